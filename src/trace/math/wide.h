/**
 * @file
 * @brief Vectors of the next wider number type: double for float. Double and quad have none that is
 *        fast, so there `wide` is #real.
 */
#ifndef DIOPTRE_TRACE_MATH_WIDE_H
#define DIOPTRE_TRACE_MATH_WIDE_H

#include "trace/math/real.h"

#if LANES > 1
/** LANES numbers. */
typedef wide_scalar wide __attribute__((vector_size(LANES * sizeof(wide_scalar))));
/** LANES truth values, from a comparison of #wide numbers. */
typedef int64_t wide_mask __attribute__((vector_size(LANES * sizeof(int64_t))));
#else
typedef wide_scalar wide;
typedef int wide_mask;
#endif

/* --- conversion ------------------------------------------------------------------------------- */

/** @return x in all lanes. */
INLINE wide wide_of(wide_scalar x) {
    return x - (wide){0};
}

/** @return The same numbers, exactly. */
INLINE wide widen(real x) {
#if defined(LANES_WIDEN)
    return LANES_WIDEN(x);
#elif LANES > 1
    return __builtin_convertvector(x, wide);
#else
    return (wide)x;
#endif
}

/** @return The nearest numbers of the engine's type. */
INLINE real narrow(wide x) {
#if defined(LANES_NARROW)
    return LANES_NARROW(x);
#elif LANES > 1
    return __builtin_convertvector(x, real);
#else
    return (real)x;
#endif
}

/** @return The same mask for #real numbers. */
INLINE mask narrow_mask(wide_mask m) {
#if defined(LANES_NARROW_MASK)
    return LANES_NARROW_MASK(m);
#elif LANES > 1
    return __builtin_convertvector(m, mask);
#else
    return m;
#endif
}

/** A lane of a #wide in memory. */
typedef wide_scalar stored_wide __attribute__((may_alias));

/** @return Lane i of numbers in memory; only this lane is loaded. */
INLINE wide_scalar wide_at(const wide *x, int i) {
    return ((const stored_wide *)x)[i];
}

/* --- comparison and selection ----------------------------------------------------------------- */

#if LANES > 1 && REAL_BITS == 32
/** Half of a #wide: as many lanes as one instruction compares. GCC compares longer vectors lane by
 *  lane, which takes ten times as long. */
typedef wide_scalar half_wide __attribute__((vector_size(LANES / 2 * sizeof(wide_scalar))));
/** Half of a #wide_mask. */
typedef int64_t half_wide_mask __attribute__((vector_size(LANES / 2 * sizeof(int64_t))));
/** A #wide by halves. */
typedef union WideHalves {
    wide whole;          /**< All lanes. */
    half_wide halves[2]; /**< The first and the last lanes. */
} WideHalves;
/** A #wide_mask by halves. */
typedef union WideMaskHalves {
    wide_mask whole;          /**< All lanes. */
    half_wide_mask halves[2]; /**< The first and the last lanes. */
} WideMaskHalves;
#endif

/** @return a < b. */
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

/** @return a <= b. */
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

/** @return a == b. */
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

/** @return The negation of each lane. */
INLINE wide_mask wide_mask_not(wide_mask m) {
#if LANES > 1
    return ~m;
#else
    return !m;
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

/* --- square roots ----------------------------------------------------------------------------- */

/** @return The square root; NaN if x is negative. */
INLINE wide wide_sqrt(wide x) {
#if defined(LANES_WIDE_SQRT)
    return LANES_WIDE_SQRT(x);
#elif LANES > 1
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
