/**
 * @file
 * @brief Ray offsets: secondary rays start off their surface, so that they do not hit it again.
 */
#ifndef DIOPTRE_TRACE_TRACER_RAY_OFFSET_H
#define DIOPTRE_TRACE_TRACER_RAY_OFFSET_H

#include "trace/tracer/ray.h"

/** Error bounds that a ray must pass to be safely behind a surface: that of the surface, and that
 * of another surface at the same position. */
#define TRANSMIT_OFFSET_BOUNDS 2
/** Offset lengths between an opaque surface that touches glass and rays that leave it: beyond its
 * own error bound, and beyond the wall of the glass, which may be before it or behind it by its
 * own. */
#define TOUCHING_OFFSET_SCALE 4
/** Smallest cosine for an offset along the ray alone: at grazing angles that would be too long. */
#define OFFSET_ALONG_MIN_COSINE ((scalar)0.0625f)

/** How far from a surface secondary rays start. */
typedef struct RayOffset {
    OffsetStrategy strategy; /**< How the distance is chosen. */
    scalar epsilon;          /**< The distance for #OFFSET_FIXED, scene units. */
} RayOffset;

/** @return The distance from the surface at which rays start, scene units. */
INLINE real ray_offset_length(const RayOffset *offset, const Hit *hit) {
    return offset->strategy == OFFSET_FIXED  ? real_of(offset->epsilon)
           : offset->strategy == OFFSET_NONE ? real_of(0)
                                             : hit->error;
}

/**
 * @return The origins of rays that leave a surface: offset along the normal, to the side of their
 *         direction (doc/tour.md, "Leaving a surface").
 * @param direction  Directions of the rays.
 */
INLINE Vec3 ray_offset_origin(const RayOffset *offset, const Hit *hit, Vec3 direction) {
    if (offset->strategy == OFFSET_NONE) {
        return hit->point;
    }
    real offset_length = ray_offset_length(offset, hit);
    mask is_outwards = vec3_dot(direction, hit->normal) >= 0;
    return vec3_add(hit->point, vec3_scale(hit->normal, real_select(is_outwards, offset_length,
                                                                    -offset_length)));
}

/**
 * @return The offset of rays along themselves, in lengths of their direction: until they are a
 *         distance from the surface. So they stay on their line.
 * @param distance  The distance from the surface, scene units.
 * @param cosine  direction . n, not negative, for the normal n on the side that the rays go to; the
 *         direction need not be a unit vector.
 * @param length  Length of the direction.
 */
INLINE real ray_offset_along_t(real distance, real cosine, real length) {
    return distance / real_max(cosine, OFFSET_ALONG_MIN_COSINE * length);
}

/**
 * @return The origins of rays that are offset along themselves. At grazing angles, the rest of the
 *         offset is along the normal.
 * @param distance  The distance from the surface, scene units.
 * @param n  The unit normal on the side that the rays go to.
 * @param direction  Directions of the rays.
 * @param cosine  direction . n, not negative.
 * @param t  The offset along the rays, by ray_offset_along_t().
 */
INLINE Vec3 ray_offset_along_origin(const Hit *hit, real distance, Vec3 n, Vec3 direction,
                                    real cosine, real t) {
    real remaining = real_max(distance - cosine * t, real_of(0));
    Vec3 origin = vec3_add(hit->point, vec3_scale(direction, t));
    return vec3_add(origin, vec3_scale(n, remaining));
}

/**
 * @return The origins of rays that are reflected at glass: one offset length before the surface, on
 *         their line. In glass a ray is totally reflected dozens of times. Along the normal it
 *         would leave its line each time, by far more than roundings.
 * @param n_front  The unit normal on the side that the rays come from.
 * @param direction  Unit directions of the reflected rays.
 */
INLINE Vec3 ray_offset_reflected_origin(const RayOffset *offset, const Hit *hit, Vec3 n_front,
                                        Vec3 direction) {
    real offset_length = ray_offset_length(offset, hit);
    real cosine = real_max(vec3_dot(direction, n_front), real_of(0));
    real t = ray_offset_along_t(offset_length, cosine, real_of(1));
    return ray_offset_along_origin(hit, offset_length, n_front, direction, cosine, t);
}

#endif
