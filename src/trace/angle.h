/**
 * @file
 * @brief Angles, by correctly rounded operations only: every machine gets the same bits.
 */
#ifndef DIOPTRE_TRACE_ANGLE_H
#define DIOPTRE_TRACE_ANGLE_H

#include "trace/root.h"

/** Half a turn, radians, in three pieces: their sum is right in every number type. */
#define HALF_TURN                                                                                  \
    ((scalar)0x1.921fb54442d18p+1 + (scalar)0x1.1a62633145c07p-53 + (scalar)-0x1.f1976b7ed8fbcp-109)

/**
 * Terms of the series that bring its rest below the number type's own rounding. Each term is
 * smaller by tan(1/32 turn)^2, which is 0.0396.
 */
#define ANGLE_TERMS (REAL_BITS == 32 ? 6 : REAL_BITS == 64 ? 12 : 25)

/**
 * @return The angle whose tangent is t, radians: halved twice, by tan(a/2) = tan a / (1 + sqrt(1 +
 *         tan^2 a)), then by the series t - t^3/3 + t^5/5 - ..., whose coefficients need no table.
 * @param t  0 to 1.
 */
INLINE real angle_of_tangent(real t) {
    const real one = real_of(1);
    t = t / (one + real_sqrt(one + t * t));
    t = t / (one + real_sqrt(one + t * t));
    real square = t * t, sum = real_of(0);
    for (int k = ANGLE_TERMS; k >= 0; k--) {
        sum = 1 / real_of((scalar)(2 * k + 1)) - square * sum;
    }
    return 4 * (t * sum);
}

/**
 * @return How far points are turned from the x axis towards the y axis: -1/2 to 1/2 turn, 0 where
 *         both are 0. The eighths of the circle are put together exactly, so that there is no seam
 *         between them.
 * @param y  Coordinates, not NaN.
 * @param x  Others.
 */
INLINE real angle_in_turns(real y, real x) {
    real across = real_abs(x), up = real_abs(y);
    real small = real_min(across, up), large = real_max(across, up);
    real tangent = real_select(large > 0, small / large, real_of(0));
    real turns = angle_of_tangent(tangent) / real_of(2 * HALF_TURN);
    turns = real_select(up > across, (scalar)0.25f - turns, turns);
    turns = real_select(x < 0, (scalar)0.5f - turns, turns);
    return real_select(y < 0, -turns, turns);
}

#endif
