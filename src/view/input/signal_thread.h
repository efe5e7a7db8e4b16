/**
 * @file
 * @brief Signals that end the program, as an event of the window.
 *
 * A signal handler must not call SDL, and an event loop that sleeps does not see a flag. So a
 * thread waits for the signals with sigwait().
 */
#ifndef DIOPTRE_VIEW_INPUT_SIGNAL_THREAD_H
#define DIOPTRE_VIEW_INPUT_SIGNAL_THREAD_H

#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

/** The signals that end the program, and the thread that waits for them. */
typedef struct SignalThread {
    sigset_t signals;        /**< The signals, except those that were ignored at the start. */
    sigset_t previous_mask;  /**< Signal mask before #signal_thread_block. */
    uint32_t event;          /**< SDL event that the first signal sends. */
    pthread_t thread;        /**< The thread. */
    bool is_started;         /**< Whether the thread runs. */
    atomic_bool should_stop; /**< Whether the thread should end. */
} SignalThread;

/** Blocks the signals in this thread and in all that it starts later. @param[out] signal_thread To
 * be ended with #signal_thread_stop. */
void signal_thread_block(SignalThread *signal_thread);

/**
 * Starts the thread: the first signal sends an SDL event, the second ends the program at once. SDL
 * must be started.
 * @param event  Type of the event.
 * @return false if the thread cannot start; the signals are unblocked then.
 */
bool signal_thread_start(SignalThread *signal_thread, uint32_t event);

/** Ends the thread and unblocks the signals. */
void signal_thread_stop(SignalThread *signal_thread);

#endif
