/**
 * @file
 * @brief What the methods need of the C library, in the number type that they are compiled for.
 */
#ifndef DIOPTRE_LAB_METHODS_REAL_FUNCTIONS_H
#define DIOPTRE_LAB_METHODS_REAL_FUNCTIONS_H

#include "trace/math/real.h"

#if REAL_BITS == 32
/** A function of the C library in the number type. */
#define REAL_FUNCTION(name) __builtin_##name##f
#elif REAL_BITS == 64
#define REAL_FUNCTION(name) __builtin_##name
#elif REAL_BITS == 80 || !defined(__SIZEOF_FLOAT128__)
#define REAL_FUNCTION(name) __builtin_##name##l
#else
#define REAL_FUNCTION(name) name##f128
extern Quadruple fmaf128(Quadruple x, Quadruple y, Quadruple z);
extern Quadruple acosf128(Quadruple x);
extern Quadruple atan2f128(Quadruple y, Quadruple x);
#endif

/** @return x y + z, rounded once. */
static inline real real_fma(real x, real y, real z) {
    return REAL_FUNCTION(fma)(x, y, z);
}

/** @return The arc cosine, 0 to pi; NaN beyond -1 to 1. */
static inline real real_acos(real x) {
    return REAL_FUNCTION(acos)(x);
}

/** @return The angle of a point, -pi to pi. */
static inline real real_atan2(real y, real x) {
    return REAL_FUNCTION(atan2)(y, x);
}

#endif
