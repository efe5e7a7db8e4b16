/**
 * @file
 * @brief Work in a child process, with a deadline that nothing can get round.
 *
 * Files of strangers are read in children: scenes, pictures and models. It lies in this room
 * because all readers may look here, while src/scene, the other room that all see, knows of no
 * processes.
 */
#ifndef DIOPTRE_ASSETS_PROCESS_SANDBOX_PROCESS_H
#define DIOPTRE_ASSETS_PROCESS_SANDBOX_PROCESS_H

#include <stdatomic.h>
#include <stddef.h>

/** How work in a child ended. */
typedef enum {
    SANDBOX_PROCESS_EXITED,     /**< By itself. */
    SANDBOX_PROCESS_TIMED_OUT,  /**< Killed at the deadline, or when its watcher had enough. */
    SANDBOX_PROCESS_CRASHED,    /**< By a signal. */
    SANDBOX_PROCESS_NOT_STARTED /**< There was no child: no memory, or too many processes. */
} SandboxProcessEnd;

/**
 * Does work in a child process, and waits for it. What the child writes is lost with it, but for
 * what it writes to memory that is shared. The child dies with this process, and is always reaped.
 * Safe in several threads at once.
 * @param[in,out] context  Handed to the work.
 * @param time_limit  How long it may take, by the clock on the wall.
 * @param[out] detail  The signal after #SANDBOX_PROCESS_CRASHED, errno after
 *         #SANDBOX_PROCESS_NOT_STARTED, else 0.
 * @return How it ended.
 */
SandboxProcessEnd sandbox_process_run(void (*task)(void *context), void *context, double time_limit,
                                      int *detail);

/** Somebody who is told, while a child works, that it still does, and who may end it. */
typedef struct SandboxProcessMonitor {
    void (*on_tick)(void *context,
                    double seconds); /**< Told the seconds since the start, or NULL. */
    void *context;                   /**< Handed to it. */
    const atomic_bool *stop; /**< The child is late once this is true; NULL: at its deadline. */
} SandboxProcessMonitor;

/**
 * Does work in a child process as #sandbox_process_run does, and tells somebody about five times a
 * second that it goes on.
 * @param[in,out] context  Handed to the work.
 * @param time_limit  How long it may take, by the clock on the wall.
 * @param monitor  Who is told, in this process and thread; NULL: nobody.
 * @param[out] detail  The signal after #SANDBOX_PROCESS_CRASHED, errno after
 *         #SANDBOX_PROCESS_NOT_STARTED, else 0.
 * @return How it ended.
 */
SandboxProcessEnd sandbox_process_run_monitored(void (*task)(void *context), void *context,
                                                double time_limit,
                                                const SandboxProcessMonitor *monitor, int *detail);

/** Lets this process, a child, take so much more memory for its own only, and be silent from now
 *  on. */
void sandbox_process_enter(size_t bytes);

/** Reserves memory that is shared with children, and used only as far as it is filled. @return The
 *  memory, zero, to be given back with munmap; NULL if there is none. */
void *sandbox_process_share_memory(size_t size);

#endif
