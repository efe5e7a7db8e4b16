/**
 * @file
 * @brief Boxes that grow, for building trees.
 */
#ifndef DIOPTRE_TRACE_BVH_BUILD_AABB_H
#define DIOPTRE_TRACE_BVH_BUILD_AABB_H

#include "trace/math/real.h"

/** Coordinates of an extent; the fourth is not used, so that four numbers fill a vector. */
enum { BUILD_AABB_SIZE = 4 };

/** A box that grows. */
typedef struct BuildAabb {
    scalar low[BUILD_AABB_SIZE];  /**< Lowest coordinates. */
    scalar high[BUILD_AABB_SIZE]; /**< Highest coordinates. */
} BuildAabb;

/** @return An extent that holds nothing. */
static inline BuildAabb build_aabb_empty(void) {
    BuildAabb e;
    for (int i = 0; i < BUILD_AABB_SIZE; i++) {
        e.low[i] = INFINITE;
        e.high[i] = -INFINITE;
    }
    return e;
}

/** Makes an extent hold another. */
static inline void build_aabb_extend(BuildAabb *e, const BuildAabb *other) {
    for (int i = 0; i < BUILD_AABB_SIZE; i++) {
        e->low[i] = other->low[i] < e->low[i] ? other->low[i] : e->low[i];
        e->high[i] = other->high[i] > e->high[i] ? other->high[i] : e->high[i];
    }
}

/** @return Half the surface of an extent: in proportion to the rays that meet it. */
static inline scalar build_aabb_half_area(const BuildAabb *e) {
    scalar x = e->high[0] - e->low[0], y = e->high[1] - e->low[1], z = e->high[2] - e->low[2];
    return x * y + y * z + z * x;
}

/** Makes an extent hold twice the middle of another. */
static inline void build_aabb_extend_centroid(BuildAabb *e, const BuildAabb *other) {
    for (int i = 0; i < BUILD_AABB_SIZE; i++) {
        scalar centroid = other->low[i] + other->high[i];
        e->low[i] = centroid < e->low[i] ? centroid : e->low[i];
        e->high[i] = centroid > e->high[i] ? centroid : e->high[i];
    }
}

#endif
