/**
 * @file
 * @brief Support functions: how far shapes reach along directions. See #ShapeClass.support.
 */
#ifndef DIOPTRE_TRACE_SHAPES_SUPPORT_H
#define DIOPTRE_TRACE_SHAPES_SUPPORT_H

#include "trace/shapes/axial_frame.h"
#include "trace/tracer/packet.h"

/** @return From one point to another. */
INLINE Vec3s support_vector(Vec3s from, Vec3sw to) {
    return vec3s_narrow(vec3sw_subtract(to, vec3s_widen(from)));
}

/** @return How far a point reaches, and the roundings of that and of the intersection with a shape.
 *  @param to The point, relative to the origin. @param size Of the shape around it. */
INLINE real support_of_point(Vec3s to, scalar size, Vec3 directions) {
    scalar slack = NARROW_BEAM_SLACK * (vec3s_abs_sum(to) + size);
    return vec3_dot(vec3_splat(to), directions) + slack * vec3_abs_sum(directions);
}

/** @return How far a box reaches. @param from The origin. */
INLINE real support_of_box(const scalar *low, const scalar *high, Vec3s from, Vec3 directions) {
    const Vec3s lowest = {low[0] - from.x, low[1] - from.y, low[2] - from.z},
                highest = {high[0] - from.x, high[1] - from.y, high[2] - from.z};
    const Vec3 a = vec3_splat(lowest), b = vec3_splat(highest), d = directions;
    scalar size = vec3s_abs_sum(lowest) + vec3s_abs_sum(highest);
    return real_max(a.x * d.x, b.x * d.x) + real_max(a.y * d.y, b.y * d.y) +
           real_max(a.z * d.z, b.z * d.z) + NARROW_BEAM_SLACK * size * vec3_abs_sum(d);
}

/** @return How far a circle of radius 1 reaches from its centre. @param axis Its axis, of length 1.
 *          Roundings of the difference are added to it: near 0 the root makes them large. */
INLINE real support_of_circle(Vec3s axis, Vec3 directions) {
    const scalar slack = 16 * ROUNDOFF;
    real length_squared = vec3_dot(directions, directions);
    real along = vec3_dot(vec3_splat(axis), directions);
    real across_squared = length_squared - along * along + slack * length_squared;
    return real_sqrt(real_max(across_squared, real_of(0)));
}

/** @return How far the wall between two circles reaches: a cylinder or a cone. @param from The
 *          origin. @param low, high Where the circles are on the axis. @param low_radius,
 *          high_radius Their radii. */
INLINE real support_of_wall(const AxialFrame *frame, wide_scalar low, wide_scalar low_radius,
                            wide_scalar high, wide_scalar high_radius, Vec3s from,
                            Vec3 directions) {
    const Vec3s axis = vec3s_narrow(frame->axes[2]), to = support_vector(from, frame->origin);
    real along = vec3_dot(vec3_splat(axis), directions);
    real circle = support_of_circle(axis, directions);
    real ends = real_max((scalar)low * along + (scalar)low_radius * circle,
                         (scalar)high * along + (scalar)high_radius * circle);
    scalar size = scalar_abs((scalar)low) + scalar_abs((scalar)high) + (scalar)low_radius +
                  (scalar)high_radius;
    return support_of_point(to, size, directions) + ends;
}

#endif
