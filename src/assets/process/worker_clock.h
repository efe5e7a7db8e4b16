/**
 * @file
 * @brief The time limits of a call to a worker process.
 *
 * A limit counts the processor time of the worker and of the answers to its questions, because a
 * busy machine must not refuse what an idle one accepts. A second, generous limit on the wall clock
 * ends workers that only wait.
 */
#ifndef DIOPTRE_ASSETS_PROCESS_WORKER_CLOCK_H
#define DIOPTRE_ASSETS_PROCESS_WORKER_CLOCK_H

#include <stdbool.h>
#include <sys/types.h>

/** The time limits of a call. */
typedef struct WorkerClock {
    double started;           /**< Start, on #clock_now_seconds. */
    double deadline;          /**< End of the limit on the wall clock. */
    clockid_t processor;      /**< Clock of the processor time of the worker. */
    double processor_started; /**< Its value at the start; negative: it cannot be read. */
    double processor_limit;   /**< Largest processor time since then, seconds. */
} WorkerClock;

/**
 * @return The limit on the wall clock of a call, seconds.
 * @param time_limit  Its limit of processor time, seconds.
 */
double worker_clock_wall_limit(double time_limit);

/** Starts a limit on the wall clock alone. @param seconds The limit. */
void worker_clock_start_wall(WorkerClock *clock, double seconds);

/**
 * Starts the limits of a call.
 * @param[out] clock  The limits.
 * @param pid         The worker.
 * @param time_limit  Limit of its processor time, seconds.
 * @param wall_limit  Limit on the wall clock, seconds; 0: #worker_clock_wall_limit.
 */
void worker_clock_start(WorkerClock *clock, pid_t pid, double time_limit, double wall_limit);

/**
 * Excludes processor time that the worker used before it was ready.
 * @param[in,out] clock  The limits.
 * @param seconds        Processor time of the worker when it was ready, as it says itself: no more
 *                       than now.
 */
void worker_clock_exclude(WorkerClock *clock, double seconds);

/** Takes from the limit the processor time that this process needed to answer the worker. @param
 *  seconds The time. */
void worker_clock_charge(WorkerClock *clock, double seconds);

/** @return Seconds since the start, on the wall clock. */
double worker_clock_elapsed(const WorkerClock *clock);

/** @return Processor time of the worker since the start, seconds; 0 if it cannot be read. */
double worker_clock_used(const WorkerClock *clock);

/** @return Seconds during which no limit can be reached by one thread; negative: one is reached. */
double worker_clock_left(const WorkerClock *clock);

/** @return Whether the limit on the wall clock is reached. */
bool worker_clock_is_stalled(const WorkerClock *clock);

#endif
