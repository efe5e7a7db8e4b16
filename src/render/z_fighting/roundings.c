/**
 * @file
 * @brief How near two surfaces must be for float to confuse them, and how often it does.
 */
#include "render/z_fighting/search.h"

#include <math.h>

/** Roundings of the two distances that are compared: of height and quotient each. The slopes of
 *  nearly parallel faces are rounded alike. */
#define DISTANCE_ROUNDINGS 4

/** Roundings of coordinates, of which each shape has its own. */
#define COORDINATE_ROUNDINGS 1

/** Roundings of directions and origins in the spaces of transformed shapes. A turned direction
 * moves a hit along the surface, which changes the whole distance, not only its part across. */
#define DIRECTION_ROUNDINGS 1

/** Roundings of a ray's offset from the surface that it leaves, in the largest coordinate, and as
 *  many again for those of the next surface. Light that leaves glass may start behind a surface
 *  that is nearer. */
#define GLASS_ROUNDINGS 32

double gap_bound(GapScale scale) {
    double coordinates = scale.is_glass ? GLASS_ROUNDINGS : COORDINATE_ROUNDINGS;
    return FLOAT_ROUNDOFF * (DISTANCE_ROUNDINGS * scale.height +
                             DIRECTION_ROUNDINGS * scale.distance + coordinates * scale.magnitude);
}

/** @return The integral of (1 - |t|)^2 / 2, the chance of an inverted order at a gap of t bounds,
 *          from 0 to t. */
static double chance_integral(double t) {
    double rest = 1 - fmin(1, fabs(t));
    return copysign((1 - rest * rest * rest) / 6, t);
}

double chance_between(double low, double high, double bound) {
    /** Smallest difference of gaps for which the integrals differ by more than roundings. */
    const double least = 1e-6;
    double from = low / bound, to = high / bound, middle = (from + to) / 2;
    double rest = 1 - fmin(1, fabs(middle));
    return to - from > least ? (chance_integral(to) - chance_integral(from)) / (to - from)
                             : rest * rest / 2;
}
