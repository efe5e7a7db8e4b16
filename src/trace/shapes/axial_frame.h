/**
 * @file
 * @brief What shapes around an axis share: their local frame, their two ends, and the interval of a
 *        ray inside them.
 */
#ifndef DIOPTRE_TRACE_SHAPES_AXIAL_FRAME_H
#define DIOPTRE_TRACE_SHAPES_AXIAL_FRAME_H

#include "trace/math/angle.h"
#include "trace/shapes/uv_frame.h"

/** Local axes of a shape around an axis: two across, and z from the base to the top. */
typedef struct AxialFrame {
    Vec3sw origin;      /**< A point of the axis. */
    Vec3sw axes[3];     /**< Local axes, unit vectors. */
    wide_scalar length; /**< Distance from base to top. */
} AxialFrame;

/** A part of LANES rays, in lengths of the direction. */
typedef struct RayInterval {
    wide near; /**< Its start. */
    wide far;  /**< Its end. */
} RayInterval;

/** LANES rays in local coordinates. */
typedef struct AxialRay {
    Vec3w origin;     /**< Points of the rays, relative to the origin of the frame. */
    Vec3w direction;  /**< Directions. */
    wide start;       /**< Where the rays start, in lengths of the direction from #origin: 0, or
                           below for a point ahead. */
    RayInterval wall; /**< The part inside the infinite wall. */
    RayInterval ends; /**< The part between the planes of the ends. */
} AxialRay;

/** Hits of LANES rays. */
typedef struct AxialHit {
    wide distance;      /**< Distance from #AxialRay.origin. */
    wide_mask is_wall;  /**< Whether on the wall; else on an end. */
    wide_mask is_entry; /**< Whether at the start of the interval: from outside. */
} AxialHit;

/** @return The coordinate axis at the largest angle to a vector: their cross product is well
 *  conditioned, and exact for vectors along an axis. */
static inline Vec3sw least_aligned_axis(Vec3d v) {
    Vec3d a = {fabs(v.x), fabs(v.y), fabs(v.z)};
    if (a.x <= a.y && a.x <= a.z) {
        return (Vec3sw){1, 0, 0};
    }
    return a.y <= a.z ? (Vec3sw){0, 1, 0} : (Vec3sw){0, 0, 1};
}

/** @return The frame of an axis. @param origin The point of the axis that is its origin. */
static inline AxialFrame axial_frame_of(Vec3d base, Vec3d top, Vec3d origin) {
    Vec3sw axis_vector = vec3sw_subtract(vec3sw_of(top), vec3sw_of(base));
    Vec3sw axis = vec3sw_normalize(axis_vector);
    Vec3sw across = vec3sw_normalize(vec3sw_cross(axis, least_aligned_axis(vec3d_of(axis))));
    return (AxialFrame){.origin = vec3sw_of(origin),
                        .axes = {across, vec3sw_cross(axis, across), axis},
                        .length = vec3sw_dot(axis_vector, axis)};
}

/** @return Vectors in local coordinates. */
INLINE Vec3w axial_frame_to_local(const AxialFrame *frame, Vec3w v) {
    return (Vec3w){vec3w_dot(vec3w_splat(frame->axes[0]), v),
                   vec3w_dot(vec3w_splat(frame->axes[1]), v),
                   vec3w_dot(vec3w_splat(frame->axes[2]), v)};
}

/** @return Vectors in the coordinates of the scene. @param v Local vectors. */
INLINE Vec3w axial_frame_to_world(const AxialFrame *frame, Vec3w v) {
    Vec3w sum = vec3w_scale(vec3w_splat(frame->axes[0]), v.x);
    sum = vec3w_add_scaled(sum, vec3w_splat(frame->axes[1]), v.y);
    return vec3w_add_scaled(sum, vec3w_splat(frame->axes[2]), v.z);
}

/** @return Points in the coordinates of the scene. @param point Local points. */
INLINE Vec3 axial_frame_to_world_point(const AxialFrame *frame, Vec3w point) {
    return vec3_narrow(vec3w_add_scaled(vec3w_splat(frame->origin),
                                        axial_frame_to_world(frame, point), wide_of(1)));
}

/** Sets rays in local coordinates. @param[out] local_ray The rays. */
INLINE void axial_ray_init(AxialRay *local_ray, const AxialFrame *frame, const Ray *ray) {
    Vec3w from_origin = vec3w_subtract(vec3_widen(ray->origin), vec3w_splat(frame->origin));
    local_ray->origin = axial_frame_to_local(frame, from_origin);
    local_ray->direction = axial_frame_to_local(frame, vec3_widen(ray->direction));
    local_ray->start = wide_of(0);
}

/**
 * Sets rays in local coordinates, represented by points ahead of their origins.
 * @param[out] local_ray  The rays.
 * @param shift           Distance to the points, in lengths of the direction; at least 0.
 */
INLINE void axial_ray_init_ahead(AxialRay *local_ray, const AxialFrame *frame, const Ray *ray,
                                 wide shift) {
    Vec3w direction = vec3_widen(ray->direction);
    Vec3w from_origin = vec3w_subtract(vec3_widen(ray->origin), vec3w_splat(frame->origin));
    from_origin = vec3w_add_scaled(from_origin, direction, shift);
    local_ray->origin = axial_frame_to_local(frame, from_origin);
    local_ray->direction = axial_frame_to_local(frame, direction);
    local_ray->start = -shift;
}

/**
 * Finds the part of rays between the planes of the ends: a slab, as in the box.
 * @param[in,out] local_ray  The rays; sets #AxialRay.ends, infinite for rays along the ends.
 * @param low                Height of the base.
 * @param high               Height of the top.
 */
INLINE void axial_ray_clip_ends(AxialRay *local_ray, wide low, wide high) {
    wide inverse = 1 / local_ray->direction.z, to_base = low - local_ray->origin.z;
    wide to_top = high - local_ray->origin.z, endless = wide_of((wide_scalar)INFINITE);
    wide_mask is_downwards = wide_less(inverse, wide_of(0));
    wide enter = wide_select(is_downwards, to_top, to_base) * inverse;
    wide leave = wide_select(is_downwards, to_base, to_top) * inverse;
    // In the plane of an end, 0 times infinity is NaN: the comparison fails, which counts as
    // inside.
    local_ray->ends.near = wide_select(wide_less(-endless, enter), enter, -endless);
    local_ray->ends.far = wide_select(wide_less(leave, endless), leave, endless);
}

/** Intersects both intervals: the capped shape. @return The lanes with a hit. */
INLINE mask axial_ray_intersect_solid(const AxialRay *local_ray, AxialHit *local_hit) {
    const RayInterval *wall = &local_ray->wall, *ends = &local_ray->ends;
    wide_mask wall_is_first = wide_less_equal(ends->near, wall->near);
    wide_mask wall_is_last = wide_less_equal(wall->far, ends->far);
    wide near = wide_select(wall_is_first, wall->near, ends->near);
    wide far = wide_select(wall_is_last, wall->far, ends->far);
    local_hit->is_entry = wide_less(local_ray->start, near);
    local_hit->distance = wide_select(local_hit->is_entry, near, far);
    local_hit->is_wall =
        (local_hit->is_entry & wall_is_first) | (wide_mask_not(local_hit->is_entry) & wall_is_last);
    return narrow_mask(wide_less_equal(near, far) & wide_less(local_ray->start, far));
}

/** @return Whether distances are ahead of the start and between the ends. */
INLINE wide_mask axial_ray_reaches(const AxialRay *local_ray, wide distance) {
    return wide_less(local_ray->start, distance) & wide_less_equal(local_ray->ends.near, distance) &
           wide_less_equal(distance, local_ray->ends.far);
}

/** Finds the first crossing of the wall between the ends: the open shape. @return The lanes with a
 *  hit. */
INLINE mask axial_ray_intersect_wall(const AxialRay *local_ray, AxialHit *local_hit) {
    const RayInterval *wall = &local_ray->wall;
    wide_mask near_is_there = axial_ray_reaches(local_ray, wall->near),
              far_is_there = axial_ray_reaches(local_ray, wall->far);
    local_hit->is_entry = near_is_there;
    local_hit->distance = wide_select(near_is_there, wall->near, wall->far);
    local_hit->is_wall = wide_equal(local_hit->distance, local_hit->distance);
    return narrow_mask(near_is_there | far_is_there);
}

/**
 * Finds points on an end.
 * @param low          Height of the base.
 * @param high         Height of the top.
 * @param[out] normal  The normals, in local coordinates.
 * @return The points, in local coordinates.
 */
INLINE Vec3w axial_ray_end_point(const AxialRay *local_ray, const AxialHit *local_hit, wide low,
                                 wide high, Vec3w *normal) {
    Vec3w point = vec3w_add_scaled(local_ray->origin, local_ray->direction, local_hit->distance);
    // A ray that enters upwards or leaves downwards is on the base.
    wide zero = wide_of(0), one = wide_of(1);
    wide_mask goes_up = wide_less(zero, local_ray->direction.z), enters = local_hit->is_entry;
    wide_mask is_base = (enters & goes_up) | wide_mask_not(enters | goes_up);
    *normal = (Vec3w){zero, zero, wide_select(is_base, -one, one)};
    point.z = wide_select(is_base, low, high);
    return point;
}

/**
 * @return Angle and height on the wall; on an end, coordinates as on a disk. The middle of the
 *         picture is at the front, opposite the first axis.
 * @param x        Along the first axis, in radii of the end; on the wall in any unit.
 * @param y        Along the second axis, in the same.
 * @param height   Height above the base, 0 to 1.
 * @param on_base  Whether on the base.
 * @param on_end   Whether on either end.
 */
INLINE TextureUv axial_texture_uv(real x, real y, real height, mask on_base, mask on_end) {
    const real half = real_of((scalar)0.5f);
    real front = -x, right = -y;
    real angle = real_atan2_turns(right, front) + half;
    real up = real_select(on_base, front, -front);
    return (TextureUv){.u = real_select(on_end, half + half * right, angle),
                       .v = real_select(on_end, half + half * up, height),
                       .wrap_u = mask_not(on_end),
                       .wrap_v = mask_of(false)};
}

#endif
