/**
 * @file
 * @brief Waiting with threads: the window's thread sleeps until the browser's thread or another
 * wakes it.
 */
#include "web/waits.h"

#include "base/clock.h"

#include <emscripten.h>
#include <emscripten/threading.h>
#include <math.h>
#include <stdatomic.h>

/** Seconds after a waking in which events are looked for each millisecond: the browser's thread
 * hands them over a little later than it wakes. */
static const double BRISK_TIME = 0.1;
/** Longest sleep, seconds, in case that a waking is missed. */
static const double LONGEST_SLEEP = 0.25;

/** Counts wakings; what is slept on. The window is one. */
static atomic_uint wake_count;
/** Count of the last waking that was seen. Of the window's thread alone. */
static unsigned seen_count;
/** When that was, on #clock_now_seconds. */
static double seen_time;

void waits_yield(void) {
    emscripten_current_thread_process_queued_calls();
}

void waits_sleep(double until) {
    double now = clock_now_seconds();
    unsigned count = atomic_load(&wake_count);
    if (count != seen_count) {
        seen_count = count;
        seen_time = now;
    }
    double delay = fmin(now - seen_time < BRISK_TIME ? 0.001 : LONGEST_SLEEP, until - now);
    emscripten_futex_wait(&wake_count, count, fmax(delay, 0) * 1e3);
    emscripten_current_thread_process_queued_calls();
}

/** Lets the window look for events. Called by the page, when it gets some. */
EMSCRIPTEN_KEEPALIVE void web_wake(void) {
    atomic_fetch_add(&wake_count, 1);
    emscripten_futex_wake(&wake_count, 1);
}

void waits_wake(void) {
    web_wake();
}

int waits_processor_count(void) {
    return emscripten_num_logical_cores();
}
