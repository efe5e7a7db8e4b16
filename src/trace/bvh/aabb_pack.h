/**
 * @file
 * @brief Boxes that are tested at once: LANES of them against a packet; in engines of one lane
 * eight against one ray (pack.h).
 *
 * Quadruple precision tests boxes in float. All that is rounded is rounded so that a box is never
 * missed: a shape more is tested now and then, and the picture has the same bits. For double this
 * would not pay: a shadow ray starts so near its surface that float cannot tell it from the box of
 * that.
 */
#ifndef DIOPTRE_TRACE_BVH_AABB_PACK_H
#define DIOPTRE_TRACE_BVH_AABB_PACK_H

#include "trace/bvh/slab.h"
#include "trace/math/pack.h"

#include <float.h>

#if LANES > 1
/** Number of boxes in a pack. */
enum { AABB_PACK_SIZE = LANES };
#else
/** Number of boxes in a pack: as in the engine that most processors prefer. The box of the scenes
 * has as many shapes. */
enum { AABB_PACK_SIZE = 8 };
#endif

/** Number of #PackReal with a number of each box. */
enum { PACK_VECTORS = AABB_PACK_SIZE / PACK_LANES };

/** A pack of boxes. */
typedef union AabbPack {
    Aabb boxes;                       /**< As a packet meets them: one per lane. */
    PackReal planes[6][PACK_VECTORS]; /**< As one ray meets them. */
} AabbPack;

#if REAL_BITS > 64

/** @return Bound on the rounding to a number of a box. @param rounded The result. */
INLINE pack_scalar pack_scalar_error(pack_scalar rounded) {
    return __builtin_fabsf(rounded) * FLT_EPSILON + FLT_MIN; // FLT_EPSILON is twice the roundoff.
}

/** @return A number of a box that is not less; NaN for numbers below its range, minus infinity
 *          included: NaN clips nothing. */
INLINE pack_scalar pack_scalar_above(scalar x) {
    pack_scalar rounded = (pack_scalar)x;
    return rounded + pack_scalar_error(rounded);
}

#else

/** @return A number of a box that is not less: the same. */
INLINE pack_scalar pack_scalar_above(scalar x) {
    return x;
}

#endif

/** @return A number of a box that is not greater. */
INLINE pack_scalar pack_scalar_below(scalar x) {
    return -pack_scalar_above(-x);
}

/** Sets a box. @param i Its index in the pack. */
INLINE void aabb_pack_set(AabbPack *pack, size_t i, Aabbs box) {
    for (int axis = 0; axis < 3; axis++) {
        pack_set_lane(pack->planes[axis], (int)i, pack_scalar_below(box.low[axis]));
        pack_set_lane(pack->planes[axis + 3], (int)i, pack_scalar_above(box.high[axis]));
    }
}

/** @return Number of packs for a number of boxes. */
static inline size_t aabb_pack_count(size_t count) {
    return (count + AABB_PACK_SIZE - 1) / AABB_PACK_SIZE;
}

/** A ray along an axis, as boxes meet it. */
typedef struct PackAxis {
    pack_scalar enter_origin;  /**< Its origin for the first planes: it meets them no later. */
    pack_scalar leave_origin;  /**< Its origin for the last planes: it meets them no earlier. */
    pack_scalar enter_inverse; /**< 1 / direction for the first planes, no larger. */
    pack_scalar leave_inverse; /**< 1 / direction for the last planes, no smaller. */
} PackAxis;

#if REAL_BITS > 64

/** #SLAB_SLACK of these numbers. */
#define PACK_SLACK (SLAB_ROUNDINGS * FLT_EPSILON / 2)

/** @return A ray along an axis. @param inverse 1 / direction. */
INLINE PackAxis pack_axis_of(scalar origin, scalar inverse) {
    const bool is_down = inverse < 0;
    const scalar size = is_down ? -inverse : inverse;
    const pack_scalar low = pack_scalar_below(origin), high = pack_scalar_above(origin),
                      less = pack_scalar_below(size), more = pack_scalar_above(size),
                      least = less > 0 ? less : 0; // Of what is beyond the range, 0.
    return is_down ? (PackAxis){low, high, -least, -more} : (PackAxis){high, low, least, more};
}

/** @return Distances along an axis. What is beyond the range is the end of it: they are lower
 *          bounds of products. NaN stays. */
INLINE PackReal pack_in_range(PackReal distance) {
    const PackReal most = FLT_MAX - (PackReal){0};
    return pack_max(-most, pack_min(most, distance));
}

/** @return Lower bounds on distances. Products below the range lose bits. */
INLINE PackReal pack_near_bound(PackReal t) {
    return pack_in_range(t) * (1 - PACK_SLACK) - 2 * FLT_MIN;
}

#else

/** #SLAB_SLACK of these numbers. */
#define PACK_SLACK SLAB_SLACK

/** @return A ray along an axis. @param inverse 1 / direction. */
INLINE PackAxis pack_axis_of(scalar origin, scalar inverse) {
    return (PackAxis){origin, origin, inverse, inverse};
}

/** @return Distances along an axis: the same. */
INLINE PackReal pack_in_range(PackReal distance) {
    return distance;
}

/** @return Lower bounds on distances. */
INLINE PackReal pack_near_bound(PackReal t) {
    return t * (1 - PACK_SLACK);
}

#endif

/** #slab_clip_ordered for one ray and some boxes. */
INLINE void pack_clip(PackReal *near, PackReal *far, PackReal enter, PackReal leave,
                      PackAxis axis) {
    *near = pack_max(pack_in_range(enter - axis.enter_origin) * axis.enter_inverse, *near);
    *far = pack_min((leave - axis.leave_origin) * axis.leave_inverse, *far);
}

/**
 * #slab_span for one ray and the boxes of a pack, in engines of one lane.
 * @param limit      The largest distance.
 * @param vectors    Number of #PackReal with boxes in them.
 * @param[out] near  Lower bounds on the distances in the boxes.
 * @return Bit i for box i.
 */
INLINE unsigned aabb_pack_meets(const Ray *ray, const AabbPack *pack, const SlabOrder *order,
                                real limit, size_t vectors, PackReal near[PACK_VECTORS]) {
    const PackReal *enter_x = pack->planes[order->enter[0]],
                   *leave_x = pack->planes[order->leave[0]],
                   *enter_y = pack->planes[order->enter[1]],
                   *leave_y = pack->planes[order->leave[1]],
                   *enter_z = pack->planes[order->enter[2]],
                   *leave_z = pack->planes[order->leave[2]];
    const Vec3s origin = vec3s_first_lane(ray->origin),
                inverse = vec3s_first_lane(ray->inverse_direction);
    const PackAxis x = pack_axis_of(origin.x, inverse.x), y = pack_axis_of(origin.y, inverse.y),
                   z = pack_axis_of(origin.z, inverse.z);
    unsigned bits = 0;
    for (size_t v = 0; v < vectors; v++) {
        PackReal t_near = {0}, t_far = pack_scalar_above(real_lane(limit, 0)) - t_near;
        pack_clip(&t_near, &t_far, enter_x[v], leave_x[v], x);
        pack_clip(&t_near, &t_far, enter_y[v], leave_y[v], y);
        pack_clip(&t_near, &t_far, enter_z[v], leave_z[v], z);
        near[v] = pack_near_bound(t_near);
        bits |= PACK_BITS(near[v] <= t_far * (1 + PACK_SLACK)) << v * PACK_LANES;
    }
    return bits;
}

#endif
