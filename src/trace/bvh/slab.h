/**
 * @file
 * @brief Intersection of rays with bounding boxes: the slab test (Kay and Kajiya, 1986).
 *
 * A box is met where a ray lies between the planes of all three pairs. A direction along an axis
 * gives infinite or NaN distances, and every comparison rejects NaN. #SLAB_SLACK enlarges both
 * sides: no rounding here or in the formula of a shape can make the test miss a hit of the shape.
 */
#ifndef DIOPTRE_TRACE_BVH_SLAB_H
#define DIOPTRE_TRACE_BVH_SLAB_H

#include "trace/tracer/packet.h"

/** Roundings of both sides. Each has three of the distance to a plane, and eight more for shapes
 *  that compute their distance by other formulas (Ize, *Robust BVH Ray Traversal*, JCGT 2013). */
#define SLAB_ROUNDINGS 22
/** Relative slack of both sides. */
#define SLAB_SLACK (SLAB_ROUNDINGS * ROUNDOFF)
/** Relative slack of a region: more than both sides of the slab test together, so that it keeps
 *  each box that a ray's own test keeps. */
#define REGION_SLACK (3 * SLAB_SLACK)

/**
 * Clips an interval to the part of rays between one pair of planes.
 * @param enter    Coordinates of the planes that rays meet first.
 * @param leave    Coordinates of the planes that they meet last.
 * @param origin   Coordinates of the origins along the axis.
 * @param inverse  1 / direction along the axis.
 */
INLINE void slab_clip_ordered(real *near, real *far, real enter, real leave, real origin,
                              real inverse) {
    *near = real_max((enter - origin) * inverse, *near);
    *far = real_min((leave - origin) * inverse, *far);
}

/** #slab_clip_ordered for planes in any order. */
INLINE void slab_clip(real *near, real *far, real low, real high, real origin, real inverse) {
    mask is_downwards = inverse < 0;
    real enter = real_select(is_downwards, high, low);
    real leave = real_select(is_downwards, low, high);
    slab_clip_ordered(near, far, enter, leave, origin, inverse);
}

/** The planes of a box in the order in which rays meet them: indices in #Aabb.planes. */
typedef struct SlabOrder {
    size_t enter[3]; /**< The first of each pair. */
    size_t leave[3]; /**< The last of each pair. */
} SlabOrder;

/** Number of octants: signs of a direction along x, y and z. */
enum { DIRECTION_OCTANTS = 8 };

/** The orders per octant. */
static const SlabOrder SLAB_ORDERS[DIRECTION_OCTANTS] = {
    {{0, 1, 2}, {3, 4, 5}}, {{3, 1, 2}, {0, 4, 5}}, {{0, 4, 2}, {3, 1, 5}}, {{3, 4, 2}, {0, 1, 5}},
    {{0, 1, 5}, {3, 4, 2}}, {{3, 1, 5}, {0, 4, 2}}, {{0, 4, 5}, {3, 1, 2}}, {{3, 4, 5}, {0, 1, 2}}};

/** @return The octant of a direction: bit i is set where it is negative along axis i. @param
 *  inverse 1 / direction. @param lane Lane of the ray. */
INLINE unsigned octant_of(const Vec3 *inverse, int lane) {
    return (real_at(&inverse->x, lane) < 0 ? 1u : 0u) | (real_at(&inverse->y, lane) < 0 ? 2u : 0u) |
           (real_at(&inverse->z, lane) < 0 ? 4u : 0u);
}

/** The parts of rays in their boxes, enlarged by #SLAB_SLACK: empty where near is beyond far. */
typedef struct SlabSpan {
    real near; /**< Lower bounds on the distances where rays enter. */
    real far;  /**< Upper bounds on those where they leave. */
} SlabSpan;

/** The bits of all axes: see slab_span(). */
enum { ALL_AXES = 7 };

/**
 * @return The parts of rays in their boxes, before their limits.
 * @param inverse     1 / direction.
 * @param order       The order in which they meet the planes along the axes that are not mixed.
 * @param mixed_axes  Bit i is set where rays may go both ways along axis i: the order of their
 *                    planes is that of the octant 0.
 * @param limit       Largest distances.
 */
INLINE SlabSpan slab_span(Vec3 origin, Vec3 inverse, const Aabb *boxes, const SlabOrder *order,
                          unsigned mixed_axes, real limit) {
    real near = real_of(0), far = limit;
    for (int axis = 0; axis < 3; axis++) {
        const real enter = boxes->planes[order->enter[axis]],
                   leave = boxes->planes[order->leave[axis]];
        const real from = vec3_component(&origin, axis), slope = vec3_component(&inverse, axis);
        if (mixed_axes >> axis & 1) {
            slab_clip(&near, &far, enter, leave, from, slope);
        } else {
            slab_clip_ordered(&near, &far, enter, leave, from, slope);
        }
    }
    return (SlabSpan){near * (1 - SLAB_SLACK), far * (1 + SLAB_SLACK)};
}

/**
 * @return The lanes whose ray meets its box before its limit.
 * @param limit      Largest distances.
 * @param[out] near  Lower bounds on the distances in the boxes.
 */
INLINE mask slab_intersects(const Ray *ray, const Aabb *boxes, real limit, real *near) {
    SlabSpan span =
        slab_span(ray->origin, ray->inverse_direction, boxes, &SLAB_ORDERS[0], ALL_AXES, limit);
    *near = span.near;
    return span.near <= span.far;
}

/** @return A box in all lanes. */
INLINE Aabb aabb_splat(Aabbs box) {
    Aabb same;
    for (int axis = 0; axis < 3; axis++) {
        same.planes[axis] = real_of(box.low[axis]);
        same.planes[axis + 3] = real_of(box.high[axis]);
    }
    return same;
}

/** @return One of LANES boxes in all lanes, its planes in an order: those that rays meet first,
 * then the others. */
INLINE Aabb aabb_splat_lane(const Aabb *boxes, int lane, const SlabOrder *order) {
    Aabb same;
    for (int axis = 0; axis < 3; axis++) {
        same.planes[axis] = real_of(real_at(&boxes->planes[order->enter[axis]], lane));
        same.planes[axis + 3] = real_of(real_at(&boxes->planes[order->leave[axis]], lane));
    }
    return same;
}

#endif
