/**
 * @file
 * @brief Ctrl-C, and its kin, as an event of the window.
 *
 * A signal handler may not call SDL, and a flag that it sets is not looked at by a loop that
 * sleeps. So a thread of its own waits for the signals, and sleeps too until one comes.
 */
#ifndef DIOPTRE_VIEW_INPUT_SIGNAL_THREAD_H
#define DIOPTRE_VIEW_INPUT_SIGNAL_THREAD_H

#include <pthread.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>

/** The signals that ask the program to end, and the thread that waits for them. */
typedef struct SignalThread {
    sigset_t signals; /**< Those that ask the program to end, unless it was told to ignore them. */
    sigset_t previous_mask;  /**< The signals that were blocked before #signal_thread_block. */
    uint32_t event;          /**< SDL event that the first signal becomes. */
    pthread_t thread;        /**< The thread that waits. */
    bool is_started;         /**< Whether the thread runs. */
    atomic_bool should_stop; /**< Whether it should end. */
} SignalThread;

/**
 * Keeps the signals from this thread and all that it starts from now on.
 * @param[out] signal_thread  The signals; give them back with #signal_thread_stop.
 */
void signal_thread_block(SignalThread *signal_thread);

/**
 * Starts to wait: the first signal becomes an SDL event, the second ends the program at once.
 * @param event  Type of the SDL event, with SDL up.
 * @return false if no thread could be started; the signals are then let through again.
 */
bool signal_thread_start(SignalThread *signal_thread, uint32_t event);

/** Stops waiting and lets the signals through again. */
void signal_thread_stop(SignalThread *signal_thread);

#endif
