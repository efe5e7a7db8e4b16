/**
 * @file
 * @brief Triangles by their corners, a triangle in each lane.
 *
 * Whether a ray passes inside a triangle is decided watertight, as for every polygon (shear.h); how
 * far away, by the plane through its corners, taken in the wide precision relative to the ray's
 * origin: the differences of float corners are exact there.
 *
 * From far away the rounding of the first is larger than small triangles, and rays pass inside that
 * the triangle's box is not on the way of; whether a tree asks about them would hang on its other
 * boxes. So a triangle is met within its own box only: then no tree can make a difference.
 */
#ifndef DIOPTRE_TRACE_CORNERS_H
#define DIOPTRE_TRACE_CORNERS_H

#include "trace/shapes/shear.h"
#include "trace/slab.h"

/** Three corners in each lane. */
typedef struct Corners {
    Vector at[3]; /**< The corners, in turn. */
} Corners;

/** Finds how far beside the rays the corners lie. @param corners Triangles. @param ray Rays.
 *  @param axis The axis that they run mainly along. @param[out] offsets Three. */
INLINE void corners_offsets(const Corners *corners, const Ray *ray, int axis, Offset *offsets) {
    Shear shear = shear_of(ray, axis);
    for (int i = 0; i < 3; i++) {
        offsets[i] = shear_offset(shear_turn(corners->at[i], axis), &shear);
    }
}

/** @return The lanes whose ray passes inside its triangle or through an edge.
 *  @param corners Triangles. @param ray Rays. @param axis The axis that they run mainly along. */
INLINE mask corners_surround(const Corners *corners, const Ray *ray, int axis) {
    Offset offsets[3];
    corners_offsets(corners, ray, axis, offsets);
    return shear_surrounds(offsets, 3);
}

/** @return Normals of the planes through triangles, of any length. @param corners Triangles. */
INLINE WideVector corners_normal(const Corners *corners) {
    WideVector a = vector_widen(corners->at[0]);
    WideVector u = wide_subtract(vector_widen(corners->at[1]), a);
    WideVector v = wide_subtract(vector_widen(corners->at[2]), a);
    return wide_cross(u, v);
}

/** @return How far away rays cross planes. @param normal The planes' normals, of any length.
 *  @param anchor A point of each. @param ray Rays. */
INLINE real plane_distance(WideVector normal, WideVector anchor, const Ray *ray) {
    WideVector to_anchor = wide_subtract(anchor, vector_widen(ray->origin));
    return narrow(wide_dot(normal, to_anchor) / wide_dot(normal, vector_widen(ray->direction)));
}

/** Finds the extent of three corners along an axis, as #corners_bounds does to the last bit.
 *  @param a A corner. @param b Another. @param c The last. @param[out] low Its lower end.
 *  @param[out] high Its higher end. */
INLINE void corners_extent(real a, real b, real c, real *low, real *high) {
    real lowest = real_min(a, real_min(b, c)), highest = real_max(a, real_max(b, c));
    real slack = BOUNDS_ROUNDINGS * BOUNDS_ROUNDOFF * real_max(highest, -lowest);
    *low = lowest - slack;
    *high = highest + slack;
}

/** @return The boxes around triangles. @param corners Triangles. */
INLINE BoundsBlock corners_boxes(const Corners *corners) {
    const Vector *a = &corners->at[0], *b = &corners->at[1], *c = &corners->at[2];
    BoundsBlock boxes;
    corners_extent(a->x, b->x, c->x, &boxes.planes[0], &boxes.planes[3]);
    corners_extent(a->y, b->y, c->y, &boxes.planes[1], &boxes.planes[4]);
    corners_extent(a->z, b->z, c->z, &boxes.planes[2], &boxes.planes[5]);
    return boxes;
}

/** @return Unit normals of the planes through triangles. @param corners Triangles. */
INLINE Vector corners_unit_normal(const Corners *corners) {
    WideVector n = corners_normal(corners);
    wide scale = 1 / wide_sqrt(wide_dot(n, n));
    return (Vector){narrow(n.x * scale), narrow(n.y * scale), narrow(n.z * scale)};
}

/** @return The share of each corner in the places where rays meet triangles: the areas between the
 *  ray and the sides opposite. @param corners Triangles. @param ray Rays.
 *  @param axis The axis that the rays run mainly along. */
INLINE Vector corners_shares(const Corners *corners, const Ray *ray, int axis) {
    Offset offsets[3];
    corners_offsets(corners, ray, axis, offsets);
    return (Vector){shear_side(offsets[1], offsets[2]), shear_side(offsets[2], offsets[0]),
                    shear_side(offsets[0], offsets[1])};
}

#endif
