/**
 * @file
 * @brief The number type of an engine: `real`, its masks, and the few functions that C's operators
 *        do not give.
 *
 * Everything in `src/trace/` is written over the types of this file and compiled once an engine,
 * with REAL_BITS (32, 64, 128) and LANES (1, 4, 8, 16) on the command line. The laboratory's
 * methods (src/lab/methods) are, too, with one lane, and with 80 bits as well.
 *
 *   scalar   one number: float, double or quad
 *   real     LANES of them, side by side; + - * / < <= work lane by lane
 *   mask     LANES answers to a comparison; & and | work on them
 *   wide     as many numbers of the next better precision, where float alone would fail
 *
 * With one lane `real` is a plain number and `mask` an int that is 0 or 1, so the compiler sees
 * textbook code. With more, both are vectors of GCC and Clang. Lane i of a wide engine has the very
 * bits of the narrow one: the operations are the same, in the same order, none is contracted, and
 * what no lane needs changes no lane.
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
/** One number of the next better precision. */
typedef double wide_scalar;
/** An integer as large as a #scalar. */
typedef int32_t lane_integer;
/** Half an ulp of 1: the largest relative error of one rounding. */
#define ROUNDOFF 0x1p-24f
#elif REAL_BITS == 64
/** One number of the engine. */
typedef double scalar;
/** One number of the next better precision: double has none that is fast. */
typedef double wide_scalar;
/** An integer as large as a #scalar. */
typedef int64_t lane_integer;
/** Half an ulp of 1: the largest relative error of one rounding. */
#define ROUNDOFF 0x1p-53
#elif REAL_BITS == 80
/** One number: 80 bits on x86, elsewhere what the machine calls long double. */
typedef long double scalar;
/** One number of the next better precision: there is none that is fast. */
typedef long double wide_scalar;
/** An integer; there is one lane only. */
typedef int lane_integer;
/** Half an ulp of 1: the largest relative error of one rounding. */
#define ROUNDOFF (__LDBL_EPSILON__ / 2)
#else
/** One number of the engine. */
typedef Quadruple scalar;
/** One number of the next better precision: quad has none. */
typedef Quadruple wide_scalar;
/** An integer; quad engines have one lane only. */
typedef int lane_integer;
/** Half an ulp of 1: the largest relative error of one rounding. */
#define ROUNDOFF ((Quadruple)0x1p-113L)
#endif

/** Larger than every distance. */
#define INFINITE ((scalar)__builtin_inf())

/** Bits of the number that the engine computes with, the leading 1 included. */
#define MANTISSA_BITS                                                                              \
    (REAL_BITS == 32 ? 24 : REAL_BITS == 64 ? 53 : REAL_BITS == 80 ? __LDBL_MANT_DIG__ : 113)

/* --- LANES of them --------------------------------------------------------------------------- */

#if LANES > 1
/** LANES numbers. */
typedef scalar real __attribute__((vector_size(LANES * sizeof(scalar))));
/** LANES answers to a comparison: 0 or all bits set. */
typedef lane_integer mask __attribute__((vector_size(LANES * sizeof(scalar))));
/** LANES numbers of the next better precision. */
typedef wide_scalar wide __attribute__((vector_size(LANES * sizeof(wide_scalar))));
/** LANES answers to a comparison of #wide numbers. */
typedef int64_t wide_mask __attribute__((vector_size(LANES * sizeof(int64_t))));
#else
typedef scalar real;
typedef int mask;
typedef wide_scalar wide;
typedef int wide_mask;
#endif

#include "trace/math/simd_x86.h"

/** LANES integers, such as the places of shapes. */
typedef mask integer;

/** A function that is part of its callers: vectors then stay in registers. */
#define INLINE static inline __attribute__((always_inline))

/* --- lanes in and out ------------------------------------------------------------------------ */

/**
 * @return One lane.
 * @param i  Which, 0 to LANES - 1.
 */
INLINE scalar real_lane(real x, int i) {
#if LANES > 1
    return x[i];
#else
    (void)i;
    return x;
#endif
}

/** A number where vectors lie in memory. */
typedef scalar stored_scalar __attribute__((may_alias));

/**
 * @return One lane of numbers that lie in memory: only that one is loaded.
 * @param i  Which, 0 to LANES - 1.
 */
INLINE scalar real_at(const real *x, int i) {
    return ((const stored_scalar *)x)[i];
}

/** A better number where vectors lie in memory. */
typedef wide_scalar stored_wide __attribute__((may_alias));

/**
 * @return One lane of better numbers that lie in memory.
 * @param i  Which, 0 to LANES - 1.
 */
INLINE wide_scalar wide_at(const wide *x, int i) {
    return ((const stored_wide *)x)[i];
}

/** Sets one lane. */
INLINE void real_set_lane(real *x, int i, scalar value) {
#if LANES > 1
    (*x)[i] = value;
#else
    (void)i;
    *x = value;
#endif
}

/**
 * @return One lane.
 * @param i  Which, 0 to LANES - 1.
 */
INLINE int integer_lane(integer x, int i) {
#if LANES > 1
    return (int)x[i];
#else
    (void)i;
    return x;
#endif
}

/** An integer where vectors lie in memory. */
typedef lane_integer stored_integer __attribute__((may_alias));

/**
 * @return One lane of integers that lie in memory: only that one is loaded.
 * @param i  Which, 0 to LANES - 1.
 */
INLINE int integer_at(const integer *x, int i) {
    return (int)((const stored_integer *)x)[i];
}

/** @return Whether a lane is set. */
INLINE bool mask_lane(mask m, int i) {
    return integer_lane(m, i) != 0;
}

/** Sets one lane. */
INLINE void mask_set_lane(mask *m, int i, bool value) {
#if LANES > 1
    (*m)[i] = value ? -1 : 0;
#else
    (void)i;
    *m = value;
#endif
}

/* The compiler spreads one number over all lanes of a vector that it is combined with. Less zero is
   that number, -0 and NaN too, and costs nothing. */

/** Sets one lane. */
INLINE void integer_set_lane(integer *x, int i, int value) {
#if LANES > 1
    (*x)[i] = value;
#else
    (void)i;
    *x = value;
#endif
}

/** @return The same number in all lanes. */
INLINE real real_of(scalar x) {
    return x - (real){0};
}

/** @return The same number in all lanes. */
INLINE wide wide_of(wide_scalar x) {
    return x - (wide){0};
}

/** @return The same integer in all lanes. */
INLINE integer integer_of(int x) {
    return x - (integer){0};
}

/* --- from one precision to the other --------------------------------------------------------- */

/** @return The same numbers, exactly. */
INLINE wide widen(real x) {
#if LANES > 1
    return __builtin_convertvector(x, wide);
#else
    return (wide)x;
#endif
}

/** @return The nearest numbers of the engine's type. */
INLINE real narrow(wide x) {
#if LANES > 1
    return __builtin_convertvector(x, real);
#else
    return (real)x;
#endif
}

/** @return The same answers. @param m A mask of better numbers. */
INLINE mask narrow_mask(wide_mask m) {
#if LANES > 1
    return __builtin_convertvector(m, mask);
#else
    return m;
#endif
}

/* --- masks ----------------------------------------------------------------------------------- */

/** @return All lanes set, or none. @param value Which of the two. */
INLINE mask mask_of(bool value) {
#if LANES > 1
    return integer_of(value ? -1 : 0);
#else
    return value;
#endif
}

/** @return The opposite answers. */
INLINE mask mask_not(mask m) {
#if LANES > 1
    return ~m;
#else
    return !m;
#endif
}

/** @return The opposite answers. @param m A mask of better numbers. */
INLINE wide_mask wide_mask_not(wide_mask m) {
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

/** What #mask_bits gives where every lane is set. */
#define ALL_LANES ((1u << LANES) - 1)

/** @return The lanes whose bit is set. @param bits Bit i for lane i. */
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
    return mask_bits(m) != 0;
}

/** @return How many lanes are set. */
INLINE unsigned mask_count(mask m) {
    return (unsigned)__builtin_popcount(mask_bits(m));
}

/** @return The first lane that is set. @param m A mask with at least one. */
INLINE int mask_first(mask m) {
    return __builtin_ctz(mask_bits(m));
}

/* --- choosing -------------------------------------------------------------------------------- */

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

/** @return a where the mask is set, b elsewhere. */
INLINE wide wide_select(wide_mask m, wide a, wide b) {
#if LANES > 1
    return (wide)((m & (wide_mask)a) | (~m & (wide_mask)b));
#else
    return m ? a : b;
#endif
}

/** @return The smaller; b where they cannot be compared. */
INLINE real real_min(real a, real b) {
    return LANES_MIN(a, b);
}

/** @return The larger; b where they cannot be compared. */
INLINE real real_max(real a, real b) {
    return LANES_MAX(a, b);
}

/** @return The absolute value. */
INLINE real real_abs(real x) {
#if LANES > 1
    return (real)((mask)x & (REAL_BITS == 32 ? INT32_MAX : INT64_MAX));
#else
    return x < 0 ? -x : x + 0;
#endif
}

/** @return The largest whole numbers that are not larger. */
INLINE real real_floor(real x) {
    // From here on a number type has whole numbers only.
    const real whole = real_of((scalar)(REAL_BITS == 32   ? 0x1p23f
                                        : REAL_BITS == 64 ? 0x1p52f
                                                          : 0x1p112f));
    real magnitude = real_abs(x);
    real to_nearest = (magnitude + whole) - whole;
    to_nearest = real_select(x < 0, -to_nearest, to_nearest);
    real floored = real_select(to_nearest > x, to_nearest - real_of(1), to_nearest);
    return real_select(magnitude < whole, floored, x);
}

/* --- from anywhere in memory ------------------------------------------------------------------ */

/**
 * @return A number for each lane.
 * @param indices  The place of each lane's, counted from there.
 */
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
