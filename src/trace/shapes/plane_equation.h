/**
 * @file
 * @brief Plane equation: what all flat shapes share.
 */
#ifndef DIOPTRE_TRACE_SHAPES_PLANE_EQUATION_H
#define DIOPTRE_TRACE_SHAPES_PLANE_EQUATION_H

#include "trace/shapes/shape.h"
#include "trace/tracer/packet.h"

/** Bound on the error of a point, in half ulps of its coordinates and of the anchor. */
#define PLANE_ERROR 8

/** Slack of plane_equation_misses_region(), in coordinates of the region and of the plane: the
 *  height of the region has a dozen roundings, and so has that of a ray of it. */
#define PLANE_REGION_SLACK (64 * ROUNDOFF)

/** A plane: all points p with normal . (p - anchor) = 0. */
struct PlaneEquation {
    Vec3sw wide_anchor; /**< A point of the plane. */
    Vec3sw wide_normal; /**< Unit normal. */
    Vec3s anchor;       /**< #wide_anchor, rounded. */
    Vec3s normal;       /**< #wide_normal, rounded. */
    scalar magnitude;   /**< Largest coordinate of the anchor: rounding errors scale with it. */
};

/** @return The plane through a point. @param normal Normal of length about 1. */
static inline PlaneEquation plane_equation_through(Vec3sw anchor, Vec3sw normal) {
    Vec3sw unit = vec3sw_normalize(normal);
    return (PlaneEquation){anchor, unit, vec3s_narrow(anchor), vec3s_narrow(unit),
                           (scalar)vec3d_max_abs(vec3d_of(anchor))};
}

/** @return The plane through a point in double. @param normal Normal of length about 1. */
static inline PlaneEquation plane_equation_of(Vec3d anchor, Vec3sw normal) {
    return plane_equation_through(vec3sw_of(anchor), normal);
}

/** Dual basis of two edges: the products of its vectors with a point of their plane are the
 *  coordinates of the point along the edges. */
typedef struct DualBasis {
    Vec3sw first;  /**< For the first edge. */
    Vec3sw second; /**< For the second edge. */
} DualBasis;

/** @return The dual basis of two edges. */
static inline DualBasis dual_basis_of(Vec3sw a, Vec3sw b) {
    Vec3sw normal = vec3sw_cross(a, b);
    wide_scalar per_area = 1 / vec3sw_dot(normal, normal);
    return (DualBasis){vec3sw_scale(vec3sw_cross(b, normal), per_area),
                       vec3sw_scale(vec3sw_cross(normal, a), per_area)};
}

/** The crossing of LANES rays with a plane, before rounding and division. */
typedef struct PlaneHit {
    Vec3w to_anchor; /**< From the origins to the anchor. */
    wide height;     /**< Height of the plane above the origins. */
    wide slope;      /**< Height gained per length of the direction. */
} PlaneHit;

/** @return The crossings. The height is relative to the origin and in the wide precision: in float
 *  it would be wrong by an ulp of the distance to the anchor (7.5e-2 at a distance of 1e6). */
INLINE PlaneHit plane_equation_intersect(const PlaneEquation *plane, const Ray *ray) {
    Vec3w normal = vec3w_splat(plane->wide_normal);
    Vec3w to_anchor = vec3w_subtract(vec3w_splat(plane->wide_anchor), vec3_widen(ray->origin));
    return (PlaneHit){to_anchor, vec3w_dot(normal, to_anchor),
                      vec3w_dot(normal, vec3_widen(ray->direction))};
}

/** @return Height of a plane above an origin, as plane_equation_intersect() rounds it. */
INLINE real plane_equation_height(const PlaneEquation *plane, Vec3s origin) {
    Vec3sw to_anchor = vec3sw_subtract(plane->wide_anchor, vec3s_widen(origin));
    return real_of((scalar)vec3sw_dot(plane->wide_normal, to_anchor));
}

/** @return Height gained per length of directions, likewise. The distance is height over slope. */
INLINE real plane_equation_slope(const PlaneEquation *plane, Vec3 direction) {
    return narrow(vec3w_dot(vec3w_splat(plane->wide_normal), vec3_widen(direction)));
}

/** @return An upper bound on the distances at which the rays of a beam meet a plane from its front;
 *          infinite where any may not. */
static inline scalar plane_equation_farthest(const PlaneEquation *plane, const Beam *beam) {
    const Vec3s n = plane->normal;
    scalar height = real_lane(plane_equation_height(plane, beam->origin), 0);
    scalar length = SCALAR_SQRT(vec3s_dot(beam->axis, beam->axis)) + vec3s_abs_sum(beam->across) +
                    vec3s_abs_sum(beam->up);
    scalar slope = vec3s_dot(n, beam->axis) + scalar_abs(vec3s_dot(n, beam->across)) +
                   scalar_abs(vec3s_dot(n, beam->up)) + BEAM_SLACK * length;
    // Both are negative for rays that come from the front and meet it before themselves.
    return height < 0 && slope < 0 ? height * length / slope * (1 + BEAM_SLACK) : INFINITE;
}

/** @return Distance of a crossing: infinite or NaN for rays along the plane. */
INLINE real plane_hit_distance(const PlaneHit *plane_hit) {
    return narrow(plane_hit->height) / narrow(plane_hit->slope);
}

/** @return Distance at which rays cross a plane. */
INLINE real plane_equation_distance(const PlaneEquation *plane, const Ray *ray) {
    PlaneHit plane_hit = plane_equation_intersect(plane, ray);
    return plane_hit_distance(&plane_hit);
}

/** @return The points of rays at a distance, moved onto the plane. */
INLINE SurfacePoint plane_equation_surface(const PlaneEquation *plane, const Ray *ray,
                                           real distance) {
    Vec3 normal = vec3_splat(plane->normal);
    Vec3 anchor = vec3_splat(plane->anchor);
    Vec3 point = vec3_add(ray->origin, vec3_scale(ray->direction, distance));
    real height = vec3_dot(normal, vec3_subtract(point, anchor));
    point = vec3_subtract(point, vec3_scale(normal, height));
    real magnitude = vec3_max_abs(point) + real_of(plane->magnitude);
    return (SurfacePoint){point, normal, PLANE_ERROR * ROUNDOFF * magnitude};
}

/** Finds the hits of a plane that all rays of a beam meet: it is equally high above all of them.
 * See #ShapeClass.beam_hits. @param self A shape in the plane. */
INLINE void plane_equation_beam_hits(const PlaneEquation *equation, const Shape *self,
                                     const Packet *packet, Hit *hits) {
    const PlaneEquation plane = *equation;
    const real height = plane_equation_height(&plane, packet->beam.origin);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Ray *ray = &packet->rays[v];
        real distance = height / plane_equation_slope(&plane, ray->direction);
        mask nearer = hit_is_nearer(&hits[v], packet->active[v], distance, self->index);
        SurfacePoint surface = plane_equation_surface(&plane, ray, distance);
        shape_update_hit(self, &hits[v], nearer, distance, &surface);
    }
}

/**
 * @return Whether all of a region is on one side of a plane. Rays within it surely miss the plane:
 *         of a ray from one height above it to another, both beyond the slack, neither the height
 *         of its origin nor the slope can round to a crossing in between.
 */
static inline bool plane_equation_misses_region(const PlaneEquation *plane, const Aabbs *region) {
    const Vec3s n = plane->normal, anchor = plane->anchor;
    const scalar normal[3] = {n.x, n.y, n.z}, origin[3] = {anchor.x, anchor.y, anchor.z};
    scalar height = 0, reach = 0, size = plane->magnitude;
    for (int axis = 0; axis < 3; axis++) {
        scalar low = region->low[axis], high = region->high[axis];
        height += normal[axis] * ((low + high) / 2 - origin[axis]);
        reach += scalar_abs(normal[axis]) * ((high - low) / 2);
        size += scalar_abs(low) + scalar_abs(high);
    }
    return scalar_abs(height) > reach + PLANE_REGION_SLACK * size;
}

#endif
