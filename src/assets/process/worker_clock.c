/**
 * @file
 * @brief The time limits of a call to a worker process.
 */
#include "assets/process/worker_clock.h"

#include "base/clock.h"

#include <math.h>
#include <time.h>

/** Seconds of the wall clock per second of processor time: a machine with 20 processes per core. */
static const double WALL_FACTOR = 20;
/** Seconds of the wall clock for small limits, in which a process may not yet run. */
static const double WALL_MINIMUM = 10;

double worker_clock_wall_limit(double time_limit) {
    return fmax(WALL_FACTOR * time_limit, 0) + WALL_MINIMUM;
}

/** @return The processor time of the worker, seconds; negative if it cannot be read. */
static double processor_seconds(const WorkerClock *clock) {
    struct timespec now;
    if (clock_gettime(clock->processor, &now) != 0) {
        return -1;
    }
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void worker_clock_start_wall(WorkerClock *clock, double seconds) {
    *clock = (WorkerClock){.started = clock_now_seconds(), .processor_started = -1};
    clock->deadline = clock->started + seconds;
}

void worker_clock_start(WorkerClock *clock, pid_t pid, double time_limit, double wall_limit) {
    worker_clock_start_wall(clock,
                            wall_limit > 0 ? wall_limit : worker_clock_wall_limit(time_limit));
    clock->processor_limit = time_limit;
    if (clock_getcpuclockid(pid, &clock->processor) == 0) {
        clock->processor_started = processor_seconds(clock);
    }
}

void worker_clock_exclude(WorkerClock *clock, double seconds) {
    if (seconds >= 0 && seconds < clock->processor_started) {
        clock->processor_started = seconds;
    }
}

void worker_clock_charge(WorkerClock *clock, double seconds) {
    clock->processor_limit -= seconds;
}

double worker_clock_elapsed(const WorkerClock *clock) {
    return clock_now_seconds() - clock->started;
}

double worker_clock_used(const WorkerClock *clock) {
    double now = clock->processor_started < 0 ? -1 : processor_seconds(clock);
    return now < 0 ? 0 : now - clock->processor_started;
}

double worker_clock_left(const WorkerClock *clock) {
    double left = clock->deadline - clock_now_seconds();
    return clock->processor_started < 0
               ? left
               : fmin(left, clock->processor_limit - worker_clock_used(clock));
}

bool worker_clock_is_stalled(const WorkerClock *clock) {
    return clock_now_seconds() >= clock->deadline;
}
