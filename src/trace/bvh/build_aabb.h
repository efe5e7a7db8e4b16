/**
 * @file
 * @brief Bounding boxes for the construction of a BVH.
 */
#ifndef DIOPTRE_TRACE_BVH_BUILD_AABB_H
#define DIOPTRE_TRACE_BVH_BUILD_AABB_H

#include "trace/math/real.h"

/** Number of coordinates; the fourth is not used, so that four numbers fill a vector. */
enum { BUILD_AABB_SIZE = 4 };

/** A bounding box. */
typedef struct BuildAabb {
    scalar low[BUILD_AABB_SIZE];  /**< Lowest coordinates. */
    scalar high[BUILD_AABB_SIZE]; /**< Highest coordinates. */
} BuildAabb;

/** @return The empty box. */
static inline BuildAabb build_aabb_empty(void) {
    BuildAabb e;
    for (int i = 0; i < BUILD_AABB_SIZE; i++) {
        e.low[i] = INFINITE;
        e.high[i] = -INFINITE;
    }
    return e;
}

/** Enlarges a box to contain another. */
static inline void build_aabb_extend(BuildAabb *e, const BuildAabb *other) {
    for (int i = 0; i < BUILD_AABB_SIZE; i++) {
        e->low[i] = other->low[i] < e->low[i] ? other->low[i] : e->low[i];
        e->high[i] = other->high[i] > e->high[i] ? other->high[i] : e->high[i];
    }
}

/** @return Half the surface area: proportional to the number of rays that meet the box. */
static inline scalar build_aabb_half_area(const BuildAabb *e) {
    scalar x = e->high[0] - e->low[0], y = e->high[1] - e->low[1], z = e->high[2] - e->low[2];
    return x * y + y * z + z * x;
}

/** Enlarges a box to contain twice the centre of another. */
static inline void build_aabb_extend_centroid(BuildAabb *e, const BuildAabb *other) {
    for (int i = 0; i < BUILD_AABB_SIZE; i++) {
        scalar centroid = other->low[i] + other->high[i];
        e->low[i] = centroid < e->low[i] ? centroid : e->low[i];
        e->high[i] = centroid > e->high[i] ? centroid : e->high[i];
    }
}

#endif
