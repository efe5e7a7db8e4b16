/**
 * @file
 * @brief The monotonic clock.
 */
#ifndef DIOPTRE_BASE_CLOCK_H
#define DIOPTRE_BASE_CLOCK_H

/** @return Seconds of the monotonic clock, which changes of the system time do not affect. */
double clock_now_seconds(void);

#endif
