/**
 * @file
 * @brief Waiting for the signals that end the program.
 */
#include "view/input/signal_thread.h"

#include "base/error.h"

#include <SDL.h>
#include <unistd.h>

/** Ends the thread: sent to it alone. Its default action is to do nothing. */
static const int WAKE_SIGNAL = SIGURG;

/** Adds a signal, unless it was ignored when the program started, as with `nohup` and in background
 * jobs of shell scripts. */
static void add_unless_ignored(sigset_t *signals, int number) {
    struct sigaction action;
    if (sigaction(number, NULL, &action) == 0 && action.sa_handler != SIG_IGN) {
        sigaddset(signals, number);
    }
}

void signal_thread_block(SignalThread *signal_thread) {
    *signal_thread = (SignalThread){0};
    sigemptyset(&signal_thread->signals);
    add_unless_ignored(&signal_thread->signals, SIGINT);
    add_unless_ignored(&signal_thread->signals, SIGTERM);
    add_unless_ignored(&signal_thread->signals, SIGHUP);
    sigaddset(&signal_thread->signals, WAKE_SIGNAL);
    pthread_sigmask(SIG_BLOCK, &signal_thread->signals, &signal_thread->previous_mask);
}

/** @return The next signal; #WAKE_SIGNAL: the thread should end. */
static int next_signal(SignalThread *signal_thread) {
    int number = 0;
    while (sigwait(&signal_thread->signals, &number) != 0 ||
           (number == WAKE_SIGNAL && !atomic_load(&signal_thread->should_stop))) {
    }
    return number;
}

/** Waits for signals, as a thread. @return NULL */
static void *signal_thread_main(void *context) {
    SignalThread *signal_thread = context;
    if (next_signal(signal_thread) == WAKE_SIGNAL) {
        return NULL;
    }
    SDL_Event event = {.type = signal_thread->event};
    SDL_PushEvent(&event);
    // The second signal ends the program at once, whatever the window does.
    if (next_signal(signal_thread) == WAKE_SIGNAL) {
        return NULL;
    }
    _exit(STATUS_INTERRUPTED);
}

bool signal_thread_start(SignalThread *signal_thread, uint32_t event) {
    signal_thread->event = event;
    signal_thread->is_started =
        pthread_create(&signal_thread->thread, NULL, signal_thread_main, signal_thread) == 0;
    if (!signal_thread->is_started) {
        pthread_sigmask(SIG_SETMASK, &signal_thread->previous_mask, NULL);
    }
    return signal_thread->is_started;
}

void signal_thread_stop(SignalThread *signal_thread) {
    if (signal_thread->is_started) {
        atomic_store(&signal_thread->should_stop, true);
        pthread_kill(signal_thread->thread, WAKE_SIGNAL);
        pthread_join(signal_thread->thread, NULL);
        signal_thread->is_started = false;
    }
    pthread_sigmask(SIG_SETMASK, &signal_thread->previous_mask, NULL);
}
