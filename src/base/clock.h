/**
 * @file
 * @brief The clock.
 */
#ifndef DIOPTRE_BASE_CLOCK_H
#define DIOPTRE_BASE_CLOCK_H

#include <time.h>

/** @return Seconds of the monotonic clock, which changes of the system time do not affect. */
double clock_now_seconds(void);

/** @return The CPU time of the calling thread, seconds. */
double clock_thread_cpu_seconds(void);

/** @return The CPU time of all threads of the process, seconds. It grows in ticks of the system,
 * some milliseconds, as soon as the CPU time of the process is limited (`ulimit -t`). */
double clock_process_cpu_seconds(void);

/** @return The time that pthread_cond_timedwait() waits for, of the system's clock. @param seconds
 *  From now, at least 0. */
struct timespec clock_deadline(double seconds);

#endif
