/**
 * @file
 * @brief What round shapes share: how far a circle reaches.
 */
#ifndef DIOPTRE_TRACE_SHAPES_CIRCLE_H
#define DIOPTRE_TRACE_SHAPES_CIRCLE_H

#include "trace/vector.h"

/**
 * @return How far a circle reaches from its centre along x, y and z: radius * sqrt(1 - n_i^2), by
 *         the other two components, because 1 - n_i^2 would cancel.
 * @param normal  The circle's unit normal.
 * @param radius  Its radius, scene units.
 */
static inline Vector3 circle_reach(WidePoint normal, wide_scalar radius) {
    double x = (double)normal.x, y = (double)normal.y, z = (double)normal.z, r = (double)radius;
    return (Vector3){r * sqrt(y * y + z * z), r * sqrt(z * z + x * x), r * sqrt(x * x + y * y)};
}

#endif
