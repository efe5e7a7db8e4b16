/**
 * @file
 * @brief Rays against boxes along the axes, for trees.
 *
 * Where a ray is between the planes of all three pairs at once (Kay and Kajiya, 1986). A direction
 * along an axis gives infinite or NaN distances, and every comparison drops the NaN. Both sides are
 * moved out by #SLAB_SLACK, so that no rounding here or in a shape's own formula can miss what the
 * shape would have met.
 */
#ifndef DIOPTRE_TRACE_SLAB_H
#define DIOPTRE_TRACE_SLAB_H

#include "trace/shape.h"

/**
 * Relative slack of either side: three roundings of a slab's distance, and eight more for the
 * shapes that find their distance by other formulas (Ize, *Robust BVH Ray Traversal*, JCGT 2013).
 */
#define SLAB_SLACK (22 * ROUNDOFF)

/**
 * Narrows an interval to the part of rays between one pair of planes.
 * @param[in,out] near  Where it begins.
 * @param[in,out] far   Where it ends.
 * @param enter   The planes that rays meet first.
 * @param leave   The planes that they meet last.
 * @param origin  Where the rays start, along the axis.
 * @param inverse 1 / direction, along the axis.
 */
INLINE void slab_narrow(real *near, real *far, real enter, real leave, real origin, real inverse) {
    *near = real_max((enter - origin) * inverse, *near);
    *far = real_min((leave - origin) * inverse, *far);
}

/**
 * Narrows an interval to the part of rays between one pair of planes, whichever is met first.
 * @param[in,out] near  Where it begins.
 * @param[in,out] far   Where it ends.
 * @param low     The lower plane.
 * @param high    The higher plane.
 * @param origin  Where the rays start, along the axis.
 * @param inverse 1 / direction, along the axis.
 */
INLINE void slab_clip(real *near, real *far, scalar low, scalar high, real origin, real inverse) {
    mask is_downwards = inverse < 0;
    real enter = real_select(is_downwards, real_of(high), real_of(low));
    real leave = real_select(is_downwards, real_of(low), real_of(high));
    slab_narrow(near, far, enter, leave, origin, inverse);
}

/**
 * @return The lanes whose ray may meet something in a box before its limit.
 * @param ray    The rays.
 * @param box    The box.
 * @param limit  How far they look.
 */
INLINE mask slab_meets(const Ray *ray, const Bounds *box, real limit) {
    real near = real_of(0), far = limit;
    slab_clip(&near, &far, box->low[0], box->high[0], ray->origin.x, ray->inverse.x);
    slab_clip(&near, &far, box->low[1], box->high[1], ray->origin.y, ray->inverse.y);
    slab_clip(&near, &far, box->low[2], box->high[2], ray->origin.z, ray->inverse.z);
    return near * (1 - SLAB_SLACK) <= far * (1 + SLAB_SLACK);
}

#endif
