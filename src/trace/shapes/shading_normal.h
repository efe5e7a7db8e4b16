/**
 * @file
 * @brief Correction of interpolated normals that point to the wrong side.
 */
#ifndef DIOPTRE_TRACE_SHAPES_SHADING_NORMAL_H
#define DIOPTRE_TRACE_SHAPES_SHADING_NORMAL_H

#include "trace/math/vec3.h"

/** Smallest cosine between an interpolated and the flat normal, about. */
#define SHADING_NORMAL_MIN_COSINE ((scalar)0.0625f)

/**
 * @return A unit normal on the same side as the flat one, seen from the surface and from the ray:
 *         else a ray could be reflected into the surface.
 * @param normal     Interpolated normals.
 * @param flat       Flat unit normals.
 * @param direction  Directions of the rays.
 */
INLINE Vec3 shading_normal_keep_side(Vec3 normal, Vec3 flat, Vec3 direction) {
    const real minimum = real_of(SHADING_NORMAL_MIN_COSINE), zero = real_of(0);
    real shortfall = real_max(minimum - vec3_dot(normal, flat), zero);
    normal = vec3_add(normal, vec3_scale(flat, shortfall));

    // Where the ray sees the back of the normal, it is bent until the ray just sees its front. The
    // direction is scaled to a length of about 1: its square could vanish.
    real largest = vec3_max_abs(direction);
    Vec3 scaled_direction = {direction.x / largest, direction.y / largest, direction.z / largest};
    real along = vec3_dot(normal, scaled_direction), side = vec3_dot(flat, scaled_direction);
    Vec3 bent = vec3_add(normal, vec3_scale(scaled_direction,
                                            -along / vec3_dot(scaled_direction, scaled_direction)));
    bent = vec3_add(bent, vec3_scale(flat, minimum));
    return vec3_normalize(vec3_select(along * side > zero, normal, bent));
}

#endif
