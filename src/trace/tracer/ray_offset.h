/**
 * @file
 * @brief How rays leave a surface: off it, so that they do not meet it again.
 */
#ifndef DIOPTRE_TRACE_TRACER_RAY_OFFSET_H
#define DIOPTRE_TRACE_TRACER_RAY_OFFSET_H

#include "trace/tracer/ray.h"

/** Bounds on the error of a hit that a ray goes before it is behind the surface for good: its own,
 *  and that of another surface at the same place. */
#define TRANSMIT_OFFSET_BOUNDS 2
/** Least cosine of a ray that is moved along itself: nearer to the surface it would go too far. */
#define TRANSMIT_OFFSET_MIN_COSINE ((scalar)0.0625f)

/** How rays leave a surface. */
typedef struct RayOffset {
    OffsetStrategy strategy; /**< Which of the three. */
    scalar epsilon;          /**< For #OFFSET_FIXED: scene units. */
} RayOffset;

/** @return How far from a surface rays start, scene units. */
INLINE real ray_offset_length(const RayOffset *offset, const Hit *hit) {
    return offset->strategy == OFFSET_FIXED  ? real_of(offset->epsilon)
           : offset->strategy == OFFSET_NONE ? real_of(0)
                                             : hit->error;
}

/**
 * @return Where rays that leave a surface start: moved along the normal, to the side that they
 *         travel to, by nothing, a fixed length or the hit's own error bound (doc/tour.md, "Leaving
 *         a surface").
 * @param direction  Which way they leave.
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
 * @return How far behind a surface rays start that go through it, in lengths of their direction:
 *         along themselves, so that they stay on their line, until they are #TRANSMIT_OFFSET_BOUNDS
 *         bounds behind the surface.
 * @param cosine  Between their direction, as long as it is, and the surface's normal; not negative.
 */
INLINE real ray_offset_transmitted_t(real offset_length, real cosine, real length) {
    return TRANSMIT_OFFSET_BOUNDS * offset_length /
           real_max(cosine, TRANSMIT_OFFSET_MIN_COSINE * length);
}

/**
 * @return Where rays start that go through a surface. Those that graze it are moved along the
 *         normal for the rest.
 * @param n_behind  The normal, on the side that the rays go to.
 * @param direction  Which way they go.
 * @param cosine  direction . onward, not negative.
 */
INLINE Vec3 ray_offset_transmitted_origin(const Hit *hit, real offset_length, Vec3 n_behind,
                                          Vec3 direction, real cosine, real t) {
    real remaining = real_max(TRANSMIT_OFFSET_BOUNDS * offset_length - cosine * t, real_of(0));
    Vec3 origin = vec3_add(hit->point, vec3_scale(direction, t));
    return vec3_add(origin, vec3_scale(n_behind, remaining));
}

#endif
