/**
 * @file
 * @brief Ctrl-C, and its kin, as an event of the window.
 */
#include "view/interrupt.h"

#include "dioptre/error.h"

#include <SDL.h>
#include <unistd.h>

/** Sent to the waiting thread, and to nobody else, to end it. By default it does nothing. */
static const int WAKE = SIGURG;

/**
 * Adds a signal to those waited for, unless the program was started with it ignored, as `nohup`
 * and shell scripts in the background do.
 * @param[in,out] signals  The set.
 * @param number           The signal.
 */
static void add_unless_ignored(sigset_t *signals, int number) {
    struct sigaction action;
    if (sigaction(number, NULL, &action) == 0 && action.sa_handler != SIG_IGN) {
        sigaddset(signals, number);
    }
}

void interrupt_block(Interrupt *interrupt) {
    *interrupt = (Interrupt){0};
    sigemptyset(&interrupt->signals);
    add_unless_ignored(&interrupt->signals, SIGINT);
    add_unless_ignored(&interrupt->signals, SIGTERM);
    add_unless_ignored(&interrupt->signals, SIGHUP);
    sigaddset(&interrupt->signals, WAKE);
    pthread_sigmask(SIG_BLOCK, &interrupt->signals, &interrupt->before);
}

/** @return The next signal that comes; #WAKE: the thread should end. @param interrupt The signals.
 */
static int next_signal(Interrupt *interrupt) {
    int number = 0;
    while (sigwait(&interrupt->signals, &number) != 0 ||
           (number == WAKE && !atomic_load(&interrupt->is_over))) {
    }
    return number;
}

/**
 * Waits for signals, as a thread.
 * @param context  The #Interrupt.
 * @return NULL
 */
static void *watch(void *context) {
    Interrupt *interrupt = context;
    if (next_signal(interrupt) == WAKE) {
        return NULL;
    }
    SDL_Event event = {.type = interrupt->event};
    SDL_PushEvent(&event);
    /* Who asks twice does not want to wait for anything. */
    if (next_signal(interrupt) == WAKE) {
        return NULL;
    }
    _exit(STATUS_INTERRUPTED);
}

bool interrupt_watch(Interrupt *interrupt, uint32_t event) {
    interrupt->event = event;
    interrupt->is_watched = pthread_create(&interrupt->thread, NULL, watch, interrupt) == 0;
    if (!interrupt->is_watched) {
        pthread_sigmask(SIG_SETMASK, &interrupt->before, NULL);
    }
    return interrupt->is_watched;
}

void interrupt_release(Interrupt *interrupt) {
    if (interrupt->is_watched) {
        atomic_store(&interrupt->is_over, true);
        pthread_kill(interrupt->thread, WAKE);
        pthread_join(interrupt->thread, NULL);
        interrupt->is_watched = false;
    }
    pthread_sigmask(SIG_SETMASK, &interrupt->before, NULL);
}
