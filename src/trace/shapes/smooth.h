/**
 * @file
 * @brief Interpolated normals, kept on the side of the surface where they make sense.
 */
#ifndef DIOPTRE_TRACE_SHAPES_SMOOTH_H
#define DIOPTRE_TRACE_SHAPES_SMOOTH_H

#include "trace/vector.h"

/** Cosine of the angle to the plane's normal that an interpolated normal has at least, about: it
 *  stays on the side of the surface that the ray comes from. */
#define SMOOTH_COSINE_MINIMUM ((scalar)0.0625f)

/**
 * @return A normal that looks to the same side of the surface as the plane's own does, from the
 *         plane and from the ray: else a ray could be mirrored into the surface. One long.
 * @param normal     An interpolated normal.
 * @param flat       The plane's normal.
 * @param direction  Which way the rays go.
 */
INLINE Vector normal_keep_side(Vector normal, Vector flat, Vector direction) {
    const real least = real_of(SMOOTH_COSINE_MINIMUM), zero = real_of(0);
    real missing = real_max(least - vector_dot(normal, flat), zero);
    normal = vector_add(normal, vector_scale(flat, missing));

    // Where the ray sees its back, it is bent until the ray just sees its front. The direction is
    // made about one long, or its square could vanish.
    real largest = vector_largest(direction);
    Vector way = {direction.x / largest, direction.y / largest, direction.z / largest};
    real along = vector_dot(normal, way), side = vector_dot(flat, way);
    Vector bent = vector_add(normal, vector_scale(way, -along / vector_dot(way, way)));
    bent = vector_add(bent, vector_scale(flat, least));
    return vector_normalize(vector_select(along * side > zero, normal, bent));
}

#endif
