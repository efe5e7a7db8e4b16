/**
 * @file
 * @brief What flat shapes share: where a ray crosses their plane.
 */
#ifndef DIOPTRE_TRACE_SHAPES_PLANE_EQUATION_H
#define DIOPTRE_TRACE_SHAPES_PLANE_EQUATION_H

#include "trace/shapes/shape.h"

/** Half ulps of the coordinates that a point can be off its plane. */
#define PLANE_ERROR 8

/** A plane: the points p with normal . (p - anchor) = 0. */
typedef struct PlaneEquation {
    Vec3sw wide_anchor; /**< A point of it. */
    Vec3sw wide_normal; /**< Its unit normal. */
    Vec3s anchor;       /**< The point, rounded. */
    Vec3s normal;       /**< The normal, rounded. */
    scalar magnitude; /**< Largest coordinate of the anchor: what its rounding errors scale with. */
} PlaneEquation;

/**
 * @return A plane.
 * @param normal  Its normal, about one long.
 */
static inline PlaneEquation plane_equation_through(Vec3sw anchor, Vec3sw normal) {
    Vec3sw unit = vec3sw_normalize(normal);
    return (PlaneEquation){anchor, unit, vec3s_narrow(anchor), vec3s_narrow(unit),
                           (scalar)vec3d_max_abs(vec3d_of(anchor))};
}

/**
 * @return A plane.
 * @param normal  Its normal, about one long.
 */
static inline PlaneEquation plane_equation_of(Vec3d anchor, Vec3sw normal) {
    return plane_equation_through(vec3sw_of(anchor), normal);
}

/** What tells how much of two edges it takes to get to a point of their plane: the products with
 *  the vector to it. */
typedef struct DualBasis {
    Vec3sw first;  /**< For the first edge. */
    Vec3sw second; /**< For the second. */
} DualBasis;

/** @return What tells the shares of two edges. */
static inline DualBasis dual_basis_of(Vec3sw a, Vec3sw b) {
    Vec3sw normal = vec3sw_cross(a, b);
    wide_scalar per_area = 1 / vec3sw_dot(normal, normal);
    return (DualBasis){vec3sw_scale(vec3sw_cross(b, normal), per_area),
                       vec3sw_scale(vec3sw_cross(normal, a), per_area)};
}

/** How LANES rays cross a plane, before anything is rounded or divided. */
typedef struct PlaneHit {
    Vec3w to_anchor; /**< From the origins to the anchor. */
    wide height;     /**< How far below the plane they start. */
    wide slope;      /**< How much they rise in one length of the direction. */
} PlaneHit;

/** @return How rays cross a plane. The height above it is taken relative to the origin and in the
 *  wide precision: in float it would be wrong by an ulp of the distance to the anchor (7.5e-2 at
 *  1e6 away). */
INLINE PlaneHit plane_equation_intersect(const PlaneEquation *plane, const Ray *ray) {
    Vec3w normal = vec3w_splat(plane->wide_normal);
    Vec3w to_anchor = vec3w_subtract(vec3w_splat(plane->wide_anchor), vec3_widen(ray->origin));
    return (PlaneHit){to_anchor, vec3w_dot(normal, to_anchor),
                      vec3w_dot(normal, vec3_widen(ray->direction))};
}

/** @return The t of a crossing: infinite or NaN where rays run along the plane. */
INLINE real plane_hit_distance(const PlaneHit *plane_hit) {
    return narrow(plane_hit->height) / narrow(plane_hit->slope);
}

/** @return The t at which rays cross a plane. */
INLINE real plane_equation_distance(const PlaneEquation *plane, const Ray *ray) {
    PlaneHit plane_hit = plane_equation_intersect(plane, ray);
    return plane_hit_distance(&plane_hit);
}

/**
 * @return Where rays cross a plane: the point of the ray, put back on the plane.
 * @param shape_index  The shape's place in the scene.
 */
INLINE Hit plane_equation_hit(const PlaneEquation *plane, const Ray *ray, real distance,
                              int shape_index) {
    Vec3 normal = vec3_splat(plane->normal);
    Vec3 anchor = vec3_splat(plane->anchor);
    Vec3 point = vec3_add(ray->origin, vec3_scale(ray->direction, distance));
    real height = vec3_dot(normal, vec3_subtract(point, anchor));
    point = vec3_subtract(point, vec3_scale(normal, height));
    real magnitude = vec3_max_abs(point) + real_of(plane->magnitude);
    return (Hit){
        distance,     point, normal, PLANE_ERROR * ROUNDOFF * magnitude, integer_of(shape_index),
        integer_of(0)};
}

#endif
