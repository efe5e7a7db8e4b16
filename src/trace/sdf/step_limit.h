/**
 * @file
 * @brief How many rays were given up on their way.
 */
#ifndef DIOPTRE_TRACE_SDF_STEP_LIMIT_H
#define DIOPTRE_TRACE_SDF_STEP_LIMIT_H

#include <stdint.h>

/** Counts rays that found neither a surface nor the end of their way within the steps that they
 *  had. Any number of threads may count at once. */
typedef struct StepLimitCounter {
    uint64_t count; /**< How many. */
} StepLimitCounter;

/** Counts rays. */
static inline void step_limit_counter_add(StepLimitCounter *counter, unsigned count) {
    if (count > 0) {
        __atomic_fetch_add(&counter->count, count, __ATOMIC_RELAXED);
    }
}

/** @return How many were counted. */
static inline uint64_t step_limit_counter_load(const StepLimitCounter *counter) {
    return __atomic_load_n(&counter->count, __ATOMIC_RELAXED);
}

#endif
