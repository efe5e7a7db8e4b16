/**
 * @file
 * @brief Sine and cosine, from correctly rounded operations only: every machine gets the same bits.
 */
#ifndef DIOPTRE_TRACE_MATH_SINE_H
#define DIOPTRE_TRACE_MATH_SINE_H

#include "trace/math/wide.h"

/**
 * Half of pi as a sum (Cody and Waite). The first three terms have 33 bits each, so that their
 * products with a number of up to 20 bits are exact in double. From FreeBSD's `e_rem_pio2.c`.
 */
static const wide_scalar half_pi_terms[] = {
    (wide_scalar)0x1.921fb544p+0, (wide_scalar)0x1.0b4611a6p-34, (wide_scalar)0x1.3198a2ep-69,
    (wide_scalar)0x1.b839a252049c1p-104};

/** Terms of the series, so that the remainder is below the rounding of the number type. */
#define SINE_TERMS (REAL_BITS == 32 ? 5 : REAL_BITS == 64 ? 9 : 16)

/** The sines and cosines of LANES angles. */
typedef struct SineCosine {
    real sine;   /**< Sines. */
    real cosine; /**< Cosines. */
} SineCosine;

/**
 * @return Sines and cosines. The error is a few ulps up to a million radians; near a zero farther
 *         than that it is more.
 * @param angle  Angles, radians.
 */
INLINE SineCosine real_sine_cosine(real angle) {
    const real one = real_of(1), zero = real_of(0);
    const scalar per_quarter = (scalar)0x1.45f306dc9c883p-1; // 2 / pi
    real quarters = real_floor(angle * per_quarter + (scalar)0.5f);
    wide rest = widen(angle);
    for (int i = 0; i < 4; i++) {
        rest = rest - widen(quarters) * half_pi_terms[i];
    }
    // The limits, of angles too large for the reduction, keep the result near [-1, 1].
    real x = real_max(real_of(-1), real_min(narrow(rest), one)), square = x * x;
    // Taylor's series by Horner's rule; what follows the first term is small.
    real sine = zero, cosine = zero;
    for (int k = SINE_TERMS; k > 0; k--) {
        const scalar n = (scalar)(2 * k);
        sine = -square * (1 + sine) * (1 / (n * (n + 1)));
        cosine = -square * (1 + cosine) * (1 / (n * (n - 1)));
    }
    sine = x + x * sine;
    cosine = one + cosine;
    real quadrant = quarters - 4 * real_floor(quarters * (scalar)0.25f);
    mask is_odd = (quadrant == 1) | (quadrant == 3);
    real s = real_select(is_odd, cosine, sine), c = real_select(is_odd, sine, cosine);
    return (SineCosine){real_select(quadrant >= 2, -s, s),
                        real_select((quadrant == 1) | (quadrant == 2), -c, c)};
}

#endif
