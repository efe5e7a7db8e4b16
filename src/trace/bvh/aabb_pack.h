/**
 * @file
 * @brief Boxes that are tested at once: LANES of them against a packet; in engines of one lane
 * eight against one ray, in vectors of 16 bytes.
 */
#ifndef DIOPTRE_TRACE_BVH_AABB_PACK_H
#define DIOPTRE_TRACE_BVH_AABB_PACK_H

#include "trace/bvh/slab.h"

#if LANES > 1
/** Number of boxes in a pack. */
enum { AABB_PACK_SIZE = LANES };
#else
/** Number of boxes in a pack: as in the engine that most processors prefer. The box of the scenes
 * has as many shapes. */
enum { AABB_PACK_SIZE = 8 };
#endif

#if LANES > 1 || REAL_BITS > 64
/** A number per box, for some boxes. */
typedef real PackReal;
/** A truth value per box. */
typedef mask PackMask;
#else
/** A number per box, for some boxes: 16 bytes, the vectors of every processor of today. */
typedef scalar PackReal __attribute__((vector_size(16)));
/** A truth value per box: 0 or all bits set. */
typedef lane_integer PackMask __attribute__((vector_size(16)));
#endif

enum {
    PACK_LANES = sizeof(PackReal) / sizeof(scalar), /**< Number of boxes in a #PackReal. */
    PACK_VECTORS = AABB_PACK_SIZE / PACK_LANES      /**< Number of those in a pack. */
};

/** A pack of boxes. */
typedef union AabbPack {
    Aabb boxes;                       /**< As a packet meets them: one per lane. */
    PackReal planes[6][PACK_VECTORS]; /**< As one ray meets them. */
} AabbPack;

/** Sets a box. @param i Its index in the pack. */
INLINE void aabb_pack_set(AabbPack *pack, size_t i, Aabbs box) {
    for (int axis = 0; axis < 3; axis++) {
        ((stored_scalar *)pack->planes[axis])[i] = box.low[axis];
        ((stored_scalar *)pack->planes[axis + 3])[i] = box.high[axis];
    }
}

/** @return The number of a box. @param i Its index in the pack. */
INLINE scalar pack_lane(const PackReal numbers[PACK_VECTORS], int i) {
    return ((const stored_scalar *)numbers)[i];
}

/** @return Number of packs for a number of boxes. */
static inline size_t aabb_pack_count(size_t count) {
    return (count + AABB_PACK_SIZE - 1) / AABB_PACK_SIZE;
}

/** @return The smaller number per box, like #real_min. */
INLINE PackReal pack_min(PackReal a, PackReal b) {
    return PACK_MIN(a, b);
}

/** @return The larger number per box, like #real_max. */
INLINE PackReal pack_max(PackReal a, PackReal b) {
    return PACK_MAX(a, b);
}

/** #slab_clip_ordered for one ray and some boxes. */
INLINE void pack_clip(PackReal *near, PackReal *far, PackReal enter, PackReal leave, real origin,
                      real inverse) {
    *near = pack_max((enter - origin) * inverse, *near);
    *far = pack_min((leave - origin) * inverse, *far);
}

/**
 * #slab_intersects_ordered for one ray and the boxes of a pack, in engines of one lane.
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
    const Vec3 origin = ray->origin, inverse = ray->inverse_direction;
    unsigned bits = 0;
    for (size_t v = 0; v < vectors; v++) {
        PackReal t_near = {0}, t_far = limit - t_near;
        pack_clip(&t_near, &t_far, enter_x[v], leave_x[v], origin.x, inverse.x);
        pack_clip(&t_near, &t_far, enter_y[v], leave_y[v], origin.y, inverse.y);
        pack_clip(&t_near, &t_far, enter_z[v], leave_z[v], origin.z, inverse.z);
        near[v] = t_near * (1 - SLAB_SLACK);
        bits |= PACK_BITS(near[v] <= t_far * (1 + SLAB_SLACK)) << v * PACK_LANES;
    }
    return bits;
}

#endif
