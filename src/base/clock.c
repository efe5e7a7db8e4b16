/**
 * @file
 * @brief The clock.
 */
#include "base/clock.h"

/** Nanoseconds per second. */
static const long NANOSECONDS = 1000000000;

/** @return Seconds of a clock. */
static double clock_seconds(clockid_t clock) {
    struct timespec now;
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double clock_now_seconds(void) {
    return clock_seconds(CLOCK_MONOTONIC);
}

double clock_thread_cpu_seconds(void) {
    return clock_seconds(CLOCK_THREAD_CPUTIME_ID);
}

double clock_process_cpu_seconds(void) {
    return clock_seconds(CLOCK_PROCESS_CPUTIME_ID);
}

struct timespec clock_deadline(double seconds) {
    struct timespec deadline;
    clock_gettime(CLOCK_REALTIME, &deadline);
    time_t whole = (time_t)seconds;
    deadline.tv_sec += whole;
    deadline.tv_nsec += (long)((seconds - (double)whole) * (double)NANOSECONDS);
    if (deadline.tv_nsec >= NANOSECONDS) {
        deadline.tv_sec++;
        deadline.tv_nsec -= NANOSECONDS;
    }
    return deadline;
}
