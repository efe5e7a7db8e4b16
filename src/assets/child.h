/**
 * @file
 * @brief Work in a child process, with a deadline that nothing can get round.
 *
 * Files of strangers are read in children: scenes, pictures and models. It lies in this room
 * because all readers may look here, while src/scene, the other room that all see, knows of no
 * processes.
 */
#ifndef ASSETS_CHILD_H
#define ASSETS_CHILD_H

#include <stdatomic.h>
#include <stddef.h>

/** How work in a child ended. */
typedef enum {
    CHILD_ENDED,    /**< By itself. */
    CHILD_LATE,     /**< Killed at the deadline, or when its watcher had enough. */
    CHILD_CRASHED,  /**< By a signal. */
    CHILD_UNSTARTED /**< There was no child: no memory, or too many processes. */
} ChildEnd;

/**
 * Does work in a child process, and waits for it. What the child writes is lost with it, but for
 * what it writes to memory that is shared. The child dies with this process, and is always reaped.
 * Safe in several threads at once.
 * @param work           The work.
 * @param[in,out] context  Handed to the work.
 * @param seconds        How long it may take, by the clock on the wall.
 * @param[out] detail    The signal after #CHILD_CRASHED, errno after #CHILD_UNSTARTED, else 0.
 * @return How it ended.
 */
ChildEnd child_run(void (*work)(void *context), void *context, double seconds, int *detail);

/** Somebody who is told, while a child works, that it still does, and who may end it. */
typedef struct ChildWatcher {
    void (*tell)(void *context, double seconds); /**< Told the seconds since the start, or NULL. */
    void *context;                               /**< Handed to it. */
    const atomic_bool *stop; /**< The child is late once this is true; NULL: at its deadline. */
} ChildWatcher;

/**
 * Does work in a child process as #child_run does, and tells somebody about five times a second
 * that it goes on.
 * @param work           The work.
 * @param[in,out] context  Handed to the work.
 * @param seconds        How long it may take, by the clock on the wall.
 * @param watcher        Who is told, in this process and thread; NULL: nobody.
 * @param[out] detail    The signal after #CHILD_CRASHED, errno after #CHILD_UNSTARTED, else 0.
 * @return How it ended.
 */
ChildEnd child_run_watched(void (*work)(void *context), void *context, double seconds,
                           const ChildWatcher *watcher, int *detail);

/**
 * Lets this process, a child, take so much more memory for its own only, and be silent from now on.
 * @param bytes  How much more.
 */
void child_withdraw(size_t bytes);

/**
 * Reserves memory that is shared with children, and used only as far as it is filled.
 * @param size  Bytes.
 * @return The memory, zero, to be given back with munmap; NULL if there is none.
 */
void *child_share_memory(size_t size);

#endif
