/**
 * @file
 * @brief Waiting for events of the window. SDL's own way looks for them each millisecond, which
 * costs 3 % of a core while nothing happens.
 */
#include "web/waits.h"

#include "base/clock.h"

#include <SDL.h>
#include <math.h>
#include <stdbool.h>

/** SDL's own function. */
int __real_SDL_PushEvent(SDL_Event *event);

/** Pushes an event, and wakes the window. SDL_PollEvent() pushes a mark behind those that it has
 * seen: to wake for it would keep the window looking for events for ever. See SDL_PushEvent(). */
int __wrap_SDL_PushEvent(SDL_Event *event) {
    bool is_mark = event->type == SDL_POLLSENTINEL;
    int status = __real_SDL_PushEvent(event);
    if (!is_mark) {
        waits_wake();
    }
    return status;
}

/** SDL's own function, which SDL_PollEvent() calls, too. */
int __real_SDL_WaitEventTimeout(SDL_Event *event, int milliseconds);

/** Waits for an event until a time. @param until Of the clock, seconds. @return Whether one came.
 */
static int wait_until(SDL_Event *event, double until) {
    waits_yield();
    int is_there = __real_SDL_WaitEventTimeout(event, 0);
    while (!is_there && clock_now_seconds() < until) {
        waits_sleep(until);
        is_there = __real_SDL_WaitEventTimeout(event, 0);
    }
    return is_there;
}

/** See SDL_WaitEvent(). */
int __wrap_SDL_WaitEvent(SDL_Event *event) {
    return wait_until(event, INFINITY);
}

/** See SDL_WaitEventTimeout(). */
int __wrap_SDL_WaitEventTimeout(SDL_Event *event, int milliseconds) {
    return wait_until(event,
                      milliseconds < 0 ? INFINITY : clock_now_seconds() + 1e-3 * milliseconds);
}
