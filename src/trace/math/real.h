/**
 * @file
 * @brief The number type of an engine: `real`, its masks, and the functions that C's operators do
 *        not provide.
 *
 * The source in `src/trace/` uses the types of this file. It is compiled once per engine, with
 * REAL_BITS (32, 64, 128) and LANES (1, 4, 8, 16) defined on the command line. The methods of the
 * laboratory (src/lab/methods) use them with one lane, and with 80 bits as well.
 *
 *   scalar   one number: float, double or quad
 *   real     a vector of LANES scalars; + - * / < <= work lane by lane
 *   mask     a vector of LANES truth values, from a comparison; & and | combine them
 *   integer  a vector of LANES integers
 *   wide     a vector in the next wider type (trace/math/wide.h), where float alone cancels
 *
 * How to read the code: as if LANES were 1. Then real is a plain float, double or quad; mask is an
 * int, 0 or 1; and `real_select(m, a, b)` is `m ? a : b`. A branch that lanes may take differently
 * becomes a select, and "if any lane" skips work that no lane needs. For example
 *
 *     mask is_hit = active & (t > 0);                if (t > 0) {
 *     if (any(is_hit)) {                                 depth = t;
 *         depth = real_select(is_hit, t, depth);     }
 *     }
 *
 * are the same for one lane, where `active` is 1. The left side does it for 8 rays at once: rays
 * that miss keep their depth. Functions named `..._of(x)` put a scalar into all lanes.
 *
 * Lane i of a wide engine gets the same bits as the engine of one lane: the operations and their
 * order are the same, none is contracted, and a select leaves other lanes unchanged.
 */
#ifndef DIOPTRE_TRACE_MATH_REAL_H
#define DIOPTRE_TRACE_MATH_REAL_H

#include "dioptre/engine.h"

#include <stdbool.h>
#include <stdint.h>

/* --- the scalar ------------------------------------------------------------------------------ */

#if REAL_BITS == 32
/** One number of the engine. */
typedef float scalar;
/** One number of the next wider type. */
typedef double wide_scalar;
/** An integer as large as a #scalar. */
typedef int32_t lane_integer;
/** Half an ulp of 1: the largest relative error of one rounding. */
#define ROUNDOFF 0x1p-24f
#elif REAL_BITS == 64
/** One number of the engine. */
typedef double scalar;
/** The next wider type: the same, as quad is too slow. */
typedef double wide_scalar;
/** An integer as large as a #scalar. */
typedef int64_t lane_integer;
/** Half an ulp of 1: the largest relative error of one rounding. */
#define ROUNDOFF 0x1p-53
#elif REAL_BITS == 80
/** One number: 80 bits on x86; long double of the machine elsewhere. */
typedef long double scalar;
/** The next wider type: the same, as quad is too slow. */
typedef long double wide_scalar;
/** An integer; there is only one lane. */
typedef int lane_integer;
/** Half an ulp of 1: the largest relative error of one rounding. */
#define ROUNDOFF (__LDBL_EPSILON__ / 2)
#else
/** One number of the engine. */
typedef Quadruple scalar;
/** The next wider type: the same, as there is none. */
typedef Quadruple wide_scalar;
/** An integer; quad engines have only one lane. */
typedef int lane_integer;
/** Half an ulp of 1: the largest relative error of one rounding. */
#define ROUNDOFF ((Quadruple)0x1p-113L)
#endif

/** Infinity: the limit of unbounded rays. */
#define INFINITE ((scalar)__builtin_inf())

/** Bits of the scalar's significand, the leading 1 included. */
#define MANTISSA_BITS                                                                              \
    (REAL_BITS == 32 ? 24 : REAL_BITS == 64 ? 53 : REAL_BITS == 80 ? __LDBL_MANT_DIG__ : 113)

/* --- LANES of them --------------------------------------------------------------------------- */

#if LANES > 1
/** LANES numbers. */
typedef scalar real __attribute__((vector_size(LANES * sizeof(scalar))));
/** LANES truth values: 0 or all bits set. */
typedef lane_integer mask __attribute__((vector_size(LANES * sizeof(scalar))));
#else
typedef scalar real;
typedef int mask;
#endif

#include "trace/math/simd_x86.h"

/** LANES integers, such as indices of shapes. */
typedef mask integer;

/** A function that is always inlined: vectors then stay in registers. */
#define INLINE static inline __attribute__((always_inline))

/* --- lanes in and out ------------------------------------------------------------------------ */

/** @return Lane i, 0 to LANES - 1. */
INLINE scalar real_lane(real x, int i) {
#if LANES > 1
    return x[i];
#else
    (void)i;
    return x;
#endif
}

/** A lane of a #real in memory. */
typedef scalar stored_scalar __attribute__((may_alias));

/** @return Lane i of numbers in memory; only this lane is loaded. */
INLINE scalar real_at(const real *x, int i) {
    return ((const stored_scalar *)x)[i];
}

/** Sets lane i. */
INLINE void real_set_lane(real *x, int i, scalar value) {
#if LANES > 1
    (*x)[i] = value;
#else
    (void)i;
    *x = value;
#endif
}

/** @return Lane i, 0 to LANES - 1. */
INLINE int integer_lane(integer x, int i) {
#if LANES > 1
    return (int)x[i];
#else
    (void)i;
    return x;
#endif
}

#if LANES > 1
/** A lane of an #integer in memory. */
typedef lane_integer stored_integer __attribute__((may_alias));
#endif

/** @return Lane i of integers in memory; only this lane is loaded. */
INLINE int integer_at(const integer *x, int i) {
#if LANES > 1
    return (int)((const stored_integer *)x)[i];
#else
    return x[i];
#endif
}

/** @return Whether lane i is set. */
INLINE bool mask_lane(mask m, int i) {
    return integer_lane(m, i) != 0;
}

/** Sets lane i. */
INLINE void mask_set_lane(mask *m, int i, bool value) {
#if LANES > 1
    (*m)[i] = value ? -1 : 0;
#else
    (void)i;
    *m = value;
#endif
}

/** Sets lane i. */
INLINE void integer_set_lane(integer *x, int i, int value) {
#if LANES > 1
    (*x)[i] = value;
#else
    (void)i;
    *x = value;
#endif
}

/** @return The numbers of the lanes: 0, 1, 2 and so on. */
INLINE integer lane_numbers(void) {
    integer numbers = {0};
    for (int i = 0; i < LANES; i++) {
        integer_set_lane(&numbers, i, i);
    }
    return numbers;
}

/* GCC spreads a scalar over all lanes of the vector that it is combined with. x - 0 is x for every
   x, -0 and NaN included, and is optimized away. */

/** @return x in all lanes. */
INLINE real real_of(scalar x) {
    return x - (real){0};
}

/** @return x in all lanes. */
INLINE integer integer_of(int x) {
    return x - (integer){0};
}

/* --- masks ----------------------------------------------------------------------------------- */

/** @return All lanes set to value. */
INLINE mask mask_of(bool value) {
#if LANES > 1
    return integer_of(value ? -1 : 0);
#else
    return value;
#endif
}

/** @return The negation of each lane. */
INLINE mask mask_not(mask m) {
#if LANES > 1
    return ~m;
#else
    return !m;
#endif
}

/** @return Bit i set where lane i is. */
INLINE unsigned mask_bits(mask m) {
#ifdef LANES_BITS
    return LANES_BITS(m);
#else
    unsigned bits = 0;
    for (int i = 0; i < LANES; i++) {
        bits |= (unsigned)mask_lane(m, i) << i;
    }
    return bits;
#endif
}

/** @return Bit i set where a is at most b in lane i. */
INLINE unsigned real_less_equal_bits(real a, real b) {
#ifdef LANES_LESS_EQUAL_BITS
    return LANES_LESS_EQUAL_BITS(a, b);
#else
    return mask_bits(a <= b);
#endif
}

/** The #mask_bits of a mask with all lanes set. */
#define ALL_LANES ((1u << LANES) - 1)

/** @return A mask with lane i set where bit i is. */
INLINE mask mask_of_bits(unsigned bits) {
#if LANES > 1
    mask lanes = {0};
    for (int i = 0; i < LANES; i++) {
        lanes[i] = 1 << i;
    }
    return (integer_of((int)bits) & lanes) == lanes;
#else
    return bits != 0;
#endif
}

/** @return Whether any lane is set. */
INLINE bool any(mask m) {
#ifdef LANES_ANY
    return LANES_ANY(m);
#else
    return mask_bits(m) != 0;
#endif
}

/** @return The number of lanes that are set. */
INLINE unsigned mask_count(mask m) {
    return (unsigned)__builtin_popcount(mask_bits(m));
}

/** @return The first lane that is set; at least one must be. */
INLINE int mask_first(mask m) {
    return __builtin_ctz(mask_bits(m));
}

/* --- selection and rounding ------------------------------------------------------------------ */

/** @return a where the mask is set, b elsewhere. */
INLINE real real_select(mask m, real a, real b) {
    return LANES_SELECT(m, a, b);
}

/** @return a where the mask is set, b elsewhere. */
INLINE integer integer_select(mask m, integer a, integer b) {
#if LANES > 1
    return (integer)real_select(m, (real)a, (real)b);
#else
    return m ? a : b;
#endif
}

/** @return The minimum; b if either is NaN. */
INLINE real real_min(real a, real b) {
    return LANES_MIN(a, b);
}

/** @return The maximum; b if either is NaN. */
INLINE real real_max(real a, real b) {
    return LANES_MAX(a, b);
}

/** @return The smallest lane, in log2(LANES) steps: each compares one half with the other. No lane
 *  may be NaN: it would hide others. */
INLINE scalar real_reduce_min(real x) {
#if LANES == 16
    x = real_min(
        x, __builtin_shufflevector(x, x, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7));
    x = real_min(
        x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3, 12, 13, 14, 15, 8, 9, 10, 11));
    x = real_min(
        x, __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5, 10, 11, 8, 9, 14, 15, 12, 13));
    x = real_min(
        x, __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6, 9, 8, 11, 10, 13, 12, 15, 14));
#elif LANES == 8
    x = real_min(x, __builtin_shufflevector(x, x, 4, 5, 6, 7, 0, 1, 2, 3));
    x = real_min(x, __builtin_shufflevector(x, x, 2, 3, 0, 1, 6, 7, 4, 5));
    x = real_min(x, __builtin_shufflevector(x, x, 1, 0, 3, 2, 5, 4, 7, 6));
#elif LANES == 4
    x = real_min(x, __builtin_shufflevector(x, x, 2, 3, 0, 1));
    x = real_min(x, __builtin_shufflevector(x, x, 1, 0, 3, 2));
#endif
    return real_lane(x, 0);
}

/** @return The largest lane. */
INLINE scalar real_reduce_max(real x) {
    return -real_reduce_min(-x);
}

/** @return The absolute value. */
INLINE real real_abs(real x) {
#if LANES > 1
    return (real)((mask)x & (REAL_BITS == 32 ? INT32_MAX : INT64_MAX));
#else
    return x < 0 ? -x : x + 0;
#endif
}

/** @return The largest integer that is not larger. */
INLINE real real_floor(real x) {
#ifdef LANES_FLOOR
    return LANES_FLOOR(x) + real_of(0); // -0 becomes 0, as below.
#else
    // From this magnitude on, all numbers of the type are integers.
    const real whole = real_of((scalar)(REAL_BITS == 32   ? 0x1p23f
                                        : REAL_BITS == 64 ? 0x1p52f
                                                          : 0x1p112f));
    real magnitude = real_abs(x);
    real to_nearest = (magnitude + whole) - whole;
    to_nearest = real_select(x < 0, -to_nearest, to_nearest);
    real floored = real_select(to_nearest > x, to_nearest - real_of(1), to_nearest);
    return real_select(magnitude < whole, floored, x);
#endif
}

/* --- square roots, correctly rounded in every number type ------------------------------------- */

#if REAL_BITS == 128
#if defined(__SIZEOF_FLOAT128__)
/** @return The square root, from the C library. */
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
/** The square root of one number of the next wider type. */
#define WIDE_SQRT __builtin_sqrt
#endif

/** @return The square root; NaN if x is negative. */
INLINE real real_sqrt(real x) {
#ifdef LANES_SQRT
    return LANES_SQRT(x);
#else
    real r = {0};
    for (int i = 0; i < LANES; i++) {
        real_set_lane(&r, i, SCALAR_SQRT(real_lane(x, i)));
    }
    return r;
#endif
}

/* --- gather ---------------------------------------------------------------------------------- */

/** @return base[indices[i]] in lane i. */
INLINE real real_gather(const scalar *base, integer indices) {
#ifdef LANES_GATHER
    return LANES_GATHER(base, indices);
#else
    real numbers = {0};
    for (int i = 0; i < LANES; i++) {
        real_set_lane(&numbers, i, base[integer_lane(indices, i)]);
    }
    return numbers;
#endif
}

#endif
