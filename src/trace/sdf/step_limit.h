/**
 * @file
 * @brief Number of rays that have reached the step limit of sphere tracing.
 */
#ifndef DIOPTRE_TRACE_SDF_STEP_LIMIT_H
#define DIOPTRE_TRACE_SDF_STEP_LIMIT_H

#include <stdint.h>

/** Counts rays that found neither a surface nor their end within the step limit. A hit before ends
 * a ray earlier, so the number depends on the order of tests; pictures do not. Thread-safe. */
typedef struct StepLimitCounter {
    uint64_t count; /**< Number of rays. */
} StepLimitCounter;

/** Adds a number of rays. */
static inline void step_limit_counter_add(StepLimitCounter *counter, unsigned count) {
    if (count > 0) {
        __atomic_fetch_add(&counter->count, count, __ATOMIC_RELAXED);
    }
}

/** @return The number of rays. */
static inline uint64_t step_limit_counter_load(const StepLimitCounter *counter) {
    return __atomic_load_n(&counter->count, __ATOMIC_RELAXED);
}

#endif
