/**
 * @file
 * @brief Rays against boxes along the axes, for trees.
 *
 * Where a ray is between the planes of all three pairs at once (Kay and Kajiya, 1986). A direction
 * along an axis gives infinite or NaN distances, and every comparison drops the NaN. Both sides are
 * moved out by #SLAB_SLACK, so that no rounding here or in a shape's own formula can miss what the
 * shape would have met.
 */
#ifndef DIOPTRE_TRACE_BVH_SLAB_H
#define DIOPTRE_TRACE_BVH_SLAB_H

#include "trace/tracer/packet.h"

/**
 * Relative slack of either side: three roundings of a slab's distance, and eight more for the
 * shapes that find their distance by other formulas (Ize, *Robust BVH Ray Traversal*, JCGT 2013).
 */
#define SLAB_SLACK (22 * ROUNDOFF)

/**
 * Narrows an interval to the part of rays between one pair of planes.
 * @param enter  The planes that rays meet first.
 * @param leave  The planes that they meet last.
 * @param origin  Where the rays start, along the axis.
 * @param inverse  1 / direction, along the axis.
 */
INLINE void slab_clip_ordered(real *near, real *far, real enter, real leave, real origin,
                              real inverse) {
    *near = real_max((enter - origin) * inverse, *near);
    *far = real_min((leave - origin) * inverse, *far);
}

/**
 * Narrows an interval to the part of rays between one pair of planes, whichever is met first.
 * @param origin  Where the rays start, along the axis.
 * @param inverse  1 / direction, along the axis.
 */
INLINE void slab_clip(real *near, real *far, real low, real high, real origin, real inverse) {
    mask is_downwards = inverse < 0;
    real enter = real_select(is_downwards, high, low);
    real leave = real_select(is_downwards, low, high);
    slab_clip_ordered(near, far, enter, leave, origin, inverse);
}

/**
 * @return The lanes whose ray may meet something in its box before its limit.
 * @param limit  How far they look.
 * @param[out] near  They meet nothing in it nearer than this.
 */
INLINE mask slab_intersects(const Ray *ray, const Aabb *boxes, real limit, real *near) {
    const real *planes = boxes->planes;
    real t_near = real_of(0), t_far = limit;
    slab_clip(&t_near, &t_far, planes[0], planes[3], ray->origin.x, ray->inverse_direction.x);
    slab_clip(&t_near, &t_far, planes[1], planes[4], ray->origin.y, ray->inverse_direction.y);
    slab_clip(&t_near, &t_far, planes[2], planes[5], ray->origin.z, ray->inverse_direction.z);
    *near = t_near * (1 - SLAB_SLACK);
    return *near <= t_far * (1 + SLAB_SLACK);
}

/** Which of a box's planes rays meet first, and which last, of each pair: places in
 *  #Aabb.planes. */
typedef struct SlabOrder {
    size_t enter[3]; /**< First. */
    size_t leave[3]; /**< Last. */
} SlabOrder;

/** Sets the order along an axis. @param is_down Whether the rays go down along it. */
INLINE void slab_order_set(SlabOrder *order, size_t axis, bool is_down) {
    order->enter[axis] = is_down ? axis + 3 : axis;
    order->leave[axis] = is_down ? axis : axis + 3;
}

/**
 * @return As #slab_intersects, bit i for lane i, for rays that all meet the planes in the same
 *         order.
 * @param origin  Where the rays start.
 * @param limit  How far they look.
 * @param[out] near  They meet nothing in it nearer than this.
 */
INLINE unsigned slab_intersects_ordered(Vec3 origin, Vec3 inverse, const Aabb *boxes,
                                        const SlabOrder *order, real limit, real *near) {
    const real *planes = boxes->planes;
    const size_t *enter = order->enter, *leave = order->leave;
    real t_near = real_of(0), t_far = limit;
    slab_clip_ordered(&t_near, &t_far, planes[enter[0]], planes[leave[0]], origin.x, inverse.x);
    slab_clip_ordered(&t_near, &t_far, planes[enter[1]], planes[leave[1]], origin.y, inverse.y);
    slab_clip_ordered(&t_near, &t_far, planes[enter[2]], planes[leave[2]], origin.z, inverse.z);
    *near = t_near * (1 - SLAB_SLACK);
    return real_less_equal_bits(*near, t_far * (1 + SLAB_SLACK));
}

/** @return The same box for every ray. */
INLINE Aabb aabb_splat_lane(const Aabb *boxes, int lane) {
    Aabb same;
    for (int i = 0; i < 6; i++) {
        same.planes[i] = real_of(real_at(&boxes->planes[i], lane));
    }
    return same;
}

#endif
