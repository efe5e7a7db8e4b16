/**
 * @file
 * @brief The clock that pictures, keys and children are timed by.
 */
#ifndef DIOPTRE_BASE_CLOCK_H
#define DIOPTRE_BASE_CLOCK_H

/** @return Seconds on the monotonic clock: nobody sets it. */
double clock_now_seconds(void);

#endif
