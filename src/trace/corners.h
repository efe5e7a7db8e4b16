/**
 * @file
 * @brief Triangles by their corners, a triangle in each lane.
 *
 * Whether a ray passes inside a triangle is decided watertight, as for every polygon (shear.h); how
 * far away, by the plane through its corners, taken in the wide precision relative to the ray's
 * origin: the differences of float corners are exact there.
 */
#ifndef DIOPTRE_TRACE_CORNERS_H
#define DIOPTRE_TRACE_CORNERS_H

#include "trace/shapes/shear.h"
#include "trace/slab.h"

/** Three corners in each lane. */
typedef struct Corners {
    Vector at[3]; /**< The corners, in turn. */
} Corners;

/** @return A vector with its axes renamed in a circle. @param v It. @param axis What becomes z. */
INLINE Vector vector_turn(Vector v, int axis) {
    return axis == 0 ? (Vector){v.y, v.z, v.x} : axis == 1 ? (Vector){v.z, v.x, v.y} : v;
}

/** Finds how far beside the rays the corners lie. @param corners Triangles. @param ray Rays.
 *  @param axis The axis that they run mainly along. @param[out] offsets Three. */
INLINE void corners_offsets(const Corners *corners, const Ray *ray, int axis, Offset *offsets) {
    Ray turned = shear_turn(ray, axis);
    for (int i = 0; i < 3; i++) {
        offsets[i] = shear_offset(vector_turn(corners->at[i], axis), &turned);
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
    return (WideVector){u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

/** @return How far away rays cross the planes of triangles. @param corners Triangles.
 *  @param ray Rays. */
INLINE real corners_distance(const Corners *corners, const Ray *ray) {
    WideVector normal = corners_normal(corners);
    WideVector to_corner = wide_subtract(vector_widen(corners->at[0]), vector_widen(ray->origin));
    return narrow(wide_dot(normal, to_corner) / wide_dot(normal, vector_widen(ray->direction)));
}

/**
 * Narrows an interval to the part of rays between the planes of triangles' boxes, the same boxes to
 * the last bit as #bounds_around makes for the tree.
 * @param[in,out] near  Where it begins.
 * @param[in,out] far   Where it ends.
 * @param a        A corner, along an axis.
 * @param b        Another.
 * @param c        The last.
 * @param origin   Where the rays start, along it.
 * @param inverse  1 / direction, along it.
 */
INLINE void corners_clip(real *near, real *far, real a, real b, real c, real origin, real inverse) {
    real low = real_min(a, real_min(b, c)), high = real_max(a, real_max(b, c));
    real reach = real_max(real_abs(low), real_abs(high));
    real slack = BOUNDS_ROUNDINGS * BOUNDS_ROUNDOFF * reach;
    mask is_downwards = inverse < 0;
    low = low - slack;
    high = high + slack;
    slab_narrow(near, far, real_select(is_downwards, high, low),
                real_select(is_downwards, low, high), origin, inverse);
}

/**
 * @return The lanes whose ray meets its triangle. From far away the rounding of #corners_surround
 *         is larger than small triangles, and rays pass that the triangle's box is not on the way
 *         of; whether a tree asks about them would hang on its other boxes. So a triangle is met
 *         within its own box only: then no tree around it can make a difference.
 * @param corners        Triangles.
 * @param ray            Rays.
 * @param inside         Those that pass inside.
 * @param[out] distance  How far away they cross it.
 */
INLINE mask corners_meet(const Corners *corners, const Ray *ray, mask inside, real *distance) {
    const Vector *a = &corners->at[0], *b = &corners->at[1], *c = &corners->at[2];
    const Vector *o = &ray->origin, *i = &ray->inverse;
    real near = real_of(0), far = real_of(INFINITE), t = corners_distance(corners, ray);
    corners_clip(&near, &far, a->x, b->x, c->x, o->x, i->x);
    corners_clip(&near, &far, a->y, b->y, c->y, o->y, i->y);
    corners_clip(&near, &far, a->z, b->z, c->z, o->z, i->z);
    near = near * (1 - SLAB_SLACK);
    *distance = real_max(t, near);
    return inside & (t > 0) & (near <= far * (1 + SLAB_SLACK));
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
