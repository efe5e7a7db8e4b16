/**
 * @file
 * @brief Arctangents, from correctly rounded operations only: every machine gets the same bits.
 */
#ifndef DIOPTRE_TRACE_MATH_ANGLE_H
#define DIOPTRE_TRACE_MATH_ANGLE_H

#include "trace/math/real.h"

/** Pi as a sum of three terms, which is exact enough for every number type. */
#define SCALAR_PI                                                                                  \
    ((scalar)0x1.921fb54442d18p+1 + (scalar)0x1.1a62633145c07p-53 + (scalar)-0x1.f1976b7ed8fbcp-109)

/**
 * Terms of the series, so that the remainder is below the rounding of the number type. Each term is
 * smaller than the last by tan(pi / 16)^2 = 0.0396.
 */
#define ATAN_TERMS (REAL_BITS == 32 ? 6 : REAL_BITS == 64 ? 12 : 25)

/** @return atan t for t from 0 to 1, radians. The angle is halved twice, by tan(a/2) = tan a / (1 +
 *  sqrt(1 + tan^2 a)); then the series t - t^3/3 + t^5/5 - ... converges fast. */
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

/** @return atan2(y, x) in turns, -1/2 to 1/2; 0 if both are 0. The octants are combined by exact
 *  operations, so that textures have no seams between them. */
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
