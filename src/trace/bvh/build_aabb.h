/**
 * @file
 * @brief Bounding boxes for the construction of a BVH.
 */
#ifndef DIOPTRE_TRACE_BVH_BUILD_AABB_H
#define DIOPTRE_TRACE_BVH_BUILD_AABB_H

#include "trace/math/real.h"

/** Number of coordinates; the fourth is not used, so that four numbers fill a vector. */
enum { BUILD_AABB_SIZE = 4 };

#if REAL_BITS == 128
/** One number of the construction. Operations of quad are functions: a tree of 100 000 spheres
 * would take seconds, in which a page with one thread does not answer. */
typedef double build_scalar;
#else
/** One number of the construction. */
typedef scalar build_scalar;
#endif

/** A bounding box. */
typedef struct BuildAabb {
    build_scalar low[BUILD_AABB_SIZE];  /**< Lowest coordinates. */
    build_scalar high[BUILD_AABB_SIZE]; /**< Highest coordinates. */
} BuildAabb;

/** @return The next number of the construction that is not greater. */
static inline build_scalar build_scalar_below(scalar x) {
    build_scalar rounded = (build_scalar)x;
    return rounded > x ? (build_scalar)__builtin_nextafter((double)rounded, -__builtin_inf())
                       : rounded;
}

/** @return The next number of the construction that is not less. */
static inline build_scalar build_scalar_above(scalar x) {
    return -build_scalar_below(-x);
}

/** @return The empty box. */
static inline BuildAabb build_aabb_empty(void) {
    BuildAabb e;
    for (int i = 0; i < BUILD_AABB_SIZE; i++) {
        e.low[i] = (build_scalar)INFINITE;
        e.high[i] = -(build_scalar)INFINITE;
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
static inline build_scalar build_aabb_half_area(const BuildAabb *e) {
    build_scalar x = e->high[0] - e->low[0], y = e->high[1] - e->low[1], z = e->high[2] - e->low[2];
    return x * y + y * z + z * x;
}

/** Enlarges a box to contain twice the centre of another. */
static inline void build_aabb_extend_centroid(BuildAabb *e, const BuildAabb *other) {
    for (int i = 0; i < BUILD_AABB_SIZE; i++) {
        build_scalar centroid = other->low[i] + other->high[i];
        e->low[i] = centroid < e->low[i] ? centroid : e->low[i];
        e->high[i] = centroid > e->high[i] ? centroid : e->high[i];
    }
}

#endif
