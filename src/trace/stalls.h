/**
 * @file
 * @brief How many rays were given up on their way.
 */
#ifndef DIOPTRE_TRACE_STALLS_H
#define DIOPTRE_TRACE_STALLS_H

#include <stdint.h>

/** Counts rays that found neither a surface nor the end of their way within the steps that they
 *  had. Any number of threads may count at once. */
typedef struct Stalls {
    uint64_t count; /**< How many. */
} Stalls;

/** Counts rays. @param[in,out] stalls The count. @param more How many. */
static inline void stalls_add(Stalls *stalls, unsigned more) {
    if (more > 0) {
        __atomic_fetch_add(&stalls->count, more, __ATOMIC_RELAXED);
    }
}

/** @return How many were counted. @param stalls The count. */
static inline uint64_t stalls_count(const Stalls *stalls) {
    return __atomic_load_n(&stalls->count, __ATOMIC_RELAXED);
}

#endif
