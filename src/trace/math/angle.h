/**
 * @file
 * @brief Angles, by correctly rounded operations only: every machine gets the same bits.
 */
#ifndef DIOPTRE_TRACE_MATH_ANGLE_H
#define DIOPTRE_TRACE_MATH_ANGLE_H

#include "trace/math/simd_sqrt.h"

/** Half a turn, radians, in three pieces: their sum is right in every number type. */
#define SCALAR_PI                                                                                  \
    ((scalar)0x1.921fb54442d18p+1 + (scalar)0x1.1a62633145c07p-53 + (scalar)-0x1.f1976b7ed8fbcp-109)

/**
 * Terms of the series that bring its rest below the number type's own rounding. Each term is
 * smaller by tan(1/32 turn)^2, which is 0.0396.
 */
#define ATAN_TERMS (REAL_BITS == 32 ? 6 : REAL_BITS == 64 ? 12 : 25)

/** @return The angle whose tangent is t, radians: halved twice, by tan(a/2) = tan a / (1 + sqrt(1 +
 *  tan^2 a)), then by the series t - t^3/3 + t^5/5 - ..., whose coefficients need no table. */
INLINE real real_atan_unit(real t) {
    const real one = real_of(1);
    t = t / (one + real_sqrt(one + t * t));
    t = t / (one + real_sqrt(one + t * t));
    real square = t * t, sum = real_of(0);
    for (int k = ATAN_TERMS; k >= 0; k--) {
        sum = 1 / real_of((scalar)(2 * k + 1)) - square * sum;
    }
    return 4 * (t * sum);
}

/** @return How far points are turned from the x axis towards the y axis: -1/2 to 1/2 turn, 0 where
 *  both are 0. The eighths of the circle are put together exactly, so that there is no seam between
 *  them. */
INLINE real real_atan2_turns(real y, real x) {
    real abs_x = real_abs(x), abs_y = real_abs(y);
    real small = real_min(abs_x, abs_y), large = real_max(abs_x, abs_y);
    real tangent = real_select(large > 0, small / large, real_of(0));
    real turns = real_atan_unit(tangent) / real_of(2 * SCALAR_PI);
    turns = real_select(abs_y > abs_x, (scalar)0.25f - turns, turns);
    turns = real_select(x < 0, (scalar)0.5f - turns, turns);
    return real_select(y < 0, -turns, turns);
}

#endif
