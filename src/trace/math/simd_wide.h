/**
 * @file
 * @brief Comparing better numbers.
 */
#ifndef DIOPTRE_TRACE_MATH_SIMD_WIDE_H
#define DIOPTRE_TRACE_MATH_SIMD_WIDE_H

#include "trace/math/real.h"

#if LANES > 1 && REAL_BITS == 32
/** Half of a #wide, as many numbers as one instruction takes: GCC compares longer vectors number by
 *  number, which takes ten times as long. */
typedef wide_scalar half_wide __attribute__((vector_size(LANES / 2 * sizeof(wide_scalar))));
/** Half of a #wide_mask. */
typedef int64_t half_wide_mask __attribute__((vector_size(LANES / 2 * sizeof(int64_t))));
/** Better numbers by halves. */
typedef union WideHalves {
    wide whole;          /**< All of them. */
    half_wide halves[2]; /**< The first and the last. */
} WideHalves;
/** A mask of better numbers by halves. */
typedef union WideMaskHalves {
    wide_mask whole;          /**< All of it. */
    half_wide_mask halves[2]; /**< The first and the last lanes. */
} WideMaskHalves;
#endif

/** @return Where a is below b. */
INLINE wide_mask wide_less(wide a, wide b) {
#if LANES > 1 && REAL_BITS == 32
    WideHalves x = {a}, y = {b};
    WideMaskHalves result;
    for (int i = 0; i < 2; i++) {
        result.halves[i] = x.halves[i] < y.halves[i];
    }
    return result.whole;
#else
    return a < b;
#endif
}

/** @return Where a is at most b. */
INLINE wide_mask wide_less_equal(wide a, wide b) {
#if LANES > 1 && REAL_BITS == 32
    WideHalves x = {a}, y = {b};
    WideMaskHalves result;
    for (int i = 0; i < 2; i++) {
        result.halves[i] = x.halves[i] <= y.halves[i];
    }
    return result.whole;
#else
    return a <= b;
#endif
}

/** @return Where a is b. */
INLINE wide_mask wide_equal(wide a, wide b) {
#if LANES > 1 && REAL_BITS == 32
    WideHalves x = {a}, y = {b};
    WideMaskHalves result;
    for (int i = 0; i < 2; i++) {
        result.halves[i] = x.halves[i] == y.halves[i];
    }
    return result.whole;
#else
    return a == b;
#endif
}

#endif
