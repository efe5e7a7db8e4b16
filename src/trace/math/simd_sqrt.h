/**
 * @file
 * @brief Square roots, correctly rounded in every number type.
 */
#ifndef DIOPTRE_TRACE_MATH_SIMD_SQRT_H
#define DIOPTRE_TRACE_MATH_SIMD_SQRT_H

#include "trace/math/real.h"

#if REAL_BITS == 128
#if defined(__SIZEOF_FLOAT128__)
/** Square root of a quad, from the C library. @return The root. */
extern Quadruple sqrtf128(Quadruple x);
/** The square root of one number. */
#define SCALAR_SQRT sqrtf128
#else
#define SCALAR_SQRT sqrtl
#endif
#define WIDE_SQRT SCALAR_SQRT
#elif REAL_BITS == 80
#define SCALAR_SQRT __builtin_sqrtl
#define WIDE_SQRT __builtin_sqrtl
#elif REAL_BITS == 64
#define SCALAR_SQRT __builtin_sqrt
#define WIDE_SQRT __builtin_sqrt
#else
/** The square root of one number. */
#define SCALAR_SQRT __builtin_sqrtf
/** The square root of one better number. */
#define WIDE_SQRT __builtin_sqrt
#endif

/** @return The square roots. @param x Numbers; NaN where they are negative. */
INLINE real real_sqrt(real x) {
    real r = {0};
    for (int i = 0; i < LANES; i++) {
        real_set_lane(&r, i, SCALAR_SQRT(real_lane(x, i)));
    }
    return r;
}

/** @return The square roots. @param x Better numbers; NaN where they are negative. */
INLINE wide wide_sqrt(wide x) {
#if LANES > 1
    wide r = {0};
    for (int i = 0; i < LANES; i++) {
        r[i] = WIDE_SQRT(x[i]);
    }
    return r;
#else
    return WIDE_SQRT(x);
#endif
}

#endif
