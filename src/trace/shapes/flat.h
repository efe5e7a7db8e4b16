/**
 * @file
 * @brief What flat shapes share: where a ray crosses their plane.
 */
#ifndef DIOPTRE_TRACE_SHAPES_FLAT_H
#define DIOPTRE_TRACE_SHAPES_FLAT_H

#include "trace/shape.h"

/** Half ulps of the coordinates that a point can be off its plane. */
#define FLAT_ERROR 8

/** A plane: the points p with normal . (p - anchor) = 0. */
typedef struct Flat {
    WidePoint wide_anchor; /**< A point of it. */
    WidePoint wide_normal; /**< Its unit normal. */
    Point anchor;          /**< The point, rounded. */
    Point normal;          /**< The normal, rounded. */
    scalar reach; /**< Largest coordinate of the anchor: what its rounding errors scale with. */
} Flat;

/** @return A plane. @param anchor A point of it. @param normal Its normal, about one long. */
static inline Flat flat_through(WidePoint anchor, WidePoint normal) {
    WidePoint unit = wide_point_normalize(normal);
    return (Flat){anchor, unit, point_narrow(anchor), point_narrow(unit),
                  (scalar)vector3_largest(vector3_of(anchor))};
}

/** @return A plane. @param anchor A point of it. @param normal Its normal, about one long. */
static inline Flat flat_of(Vector3 anchor, WidePoint normal) {
    return flat_through(wide_point_of(anchor), normal);
}

/** What tells how much of two edges it takes to get to a point of their plane: the products with
 *  the vector to it. */
typedef struct Shares {
    WidePoint of_first;  /**< For the first edge. */
    WidePoint of_second; /**< For the second. */
} Shares;

/** @return What tells the shares of two edges. @param a One. @param b Another, not parallel. */
static inline Shares shares_of(WidePoint a, WidePoint b) {
    WidePoint normal = wide_point_cross(a, b);
    wide_scalar per_area = 1 / wide_point_dot(normal, normal);
    return (Shares){wide_point_scale(wide_point_cross(b, normal), per_area),
                    wide_point_scale(wide_point_cross(normal, a), per_area)};
}

/** How LANES rays cross a plane, before anything is rounded or divided. */
typedef struct Crossing {
    WideVector to_anchor; /**< From the origins to the anchor. */
    wide height;          /**< How far below the plane they start. */
    wide slope;           /**< How much they rise in one length of the direction. */
} Crossing;

/**
 * @return How rays cross a plane. The height above it is taken relative to the origin and in the
 *         wide precision: in float it would be wrong by an ulp of the distance to the anchor
 * (7.5e-2 at 1e6 away).
 * @param flat  The plane.
 * @param ray   The rays.
 */
INLINE Crossing flat_crossing(const Flat *flat, const Ray *ray) {
    WideVector normal = wide_vector_of(flat->wide_normal);
    WideVector to_anchor =
        wide_subtract(wide_vector_of(flat->wide_anchor), vector_widen(ray->origin));
    return (Crossing){to_anchor, wide_dot(normal, to_anchor),
                      wide_dot(normal, vector_widen(ray->direction))};
}

/** @return The t of a crossing: infinite or NaN where rays run along the plane.
 *  @param crossing The crossing. */
INLINE real crossing_distance(const Crossing *crossing) {
    return narrow(crossing->height) / narrow(crossing->slope);
}

/** @return The t at which rays cross a plane. @param flat The plane. @param ray The rays. */
INLINE real flat_distance(const Flat *flat, const Ray *ray) {
    Crossing crossing = flat_crossing(flat, ray);
    return crossing_distance(&crossing);
}

/**
 * @return Where rays cross a plane: the point of the ray, put back on the plane.
 * @param flat      The plane.
 * @param ray       The rays.
 * @param distance  What #flat_distance said.
 * @param place     The shape's place in the scene.
 */
INLINE Hit flat_hit(const Flat *flat, const Ray *ray, real distance, int place) {
    Vector normal = vector_of_point(flat->normal);
    Vector anchor = vector_of_point(flat->anchor);
    Vector point = vector_add(ray->origin, vector_scale(ray->direction, distance));
    real height = vector_dot(normal, vector_subtract(point, anchor));
    point = vector_subtract(point, vector_scale(normal, height));
    real reach = vector_largest(point) + real_of(flat->reach);
    return (Hit){distance,          point,        normal, FLAT_ERROR * ROUNDOFF * reach,
                 integer_of(place), integer_of(0)};
}

#endif
