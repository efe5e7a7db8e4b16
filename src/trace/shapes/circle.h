/**
 * @file
 * @brief What round shapes share: how far a circle reaches.
 */
#ifndef DIOPTRE_TRACE_SHAPES_CIRCLE_H
#define DIOPTRE_TRACE_SHAPES_CIRCLE_H

#include "trace/math/vec3.h"

/**
 * @return How far a circle reaches from its centre along x, y and z: radius * sqrt(1 - n_i^2), by
 *         the other two components, because 1 - n_i^2 would cancel.
 * @param normal  The circle's unit normal.
 * @param radius  Its radius, scene units.
 */
static inline Vec3d circle_extent(Vec3sw normal, wide_scalar radius) {
    double x = (double)normal.x, y = (double)normal.y, z = (double)normal.z, r = (double)radius;
    return (Vec3d){r * sqrt(y * y + z * z), r * sqrt(z * z + x * x), r * sqrt(x * x + y * y)};
}

#endif
