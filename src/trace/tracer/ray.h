/**
 * @file
 * @brief Rays and hits: the input and the output of every intersection test.
 */
#ifndef DIOPTRE_TRACE_TRACER_RAY_H
#define DIOPTRE_TRACE_TRACER_RAY_H

#include "trace/math/vec3.h"

/** LANES rays: the points origin + t direction, t > 0. The direction has any length but 0. */
typedef struct Ray {
    Vec3 origin;            /**< Origins. */
    Vec3 direction;         /**< Directions. */
    Vec3 inverse_direction; /**< 1 / direction, for slab tests; infinite where a component is 0. */
} Ray;

/** The nearest hits of LANES rays so far. `is_hit` of a shape says whether a ray hits it, where
 *  (point), and with which normal. */
typedef struct Hit {
    real distance; /**< The t of the hit; of no hit, the largest t that counts. */
    Vec3 point;    /**< The hit point. */
    Vec3 normal;   /**< The surface's outward unit normal there. */
    real error;    /**< Error bound: distance from #point to the surface at most, scene units. */
    integer shape; /**< Index of the shape in the scene; -1: no hit. */
    integer primitive; /**< Of a mesh, the triangle: its slot in the mesh's blocks. Other shapes do
                            not set it. */
} Hit;

/** @return LANES rays. @param direction Their directions, not zero. */
INLINE Ray ray_of(Vec3 origin, Vec3 direction) {
    Vec3 inverse = {1 / direction.x, 1 / direction.y, 1 / direction.z};
    return (Ray){origin, direction, inverse};
}

/** @return No hit. @param limit The largest distance that counts. */
INLINE Hit hit_none(real limit) {
    Vec3 zero = {real_of(0), real_of(0), real_of(0)};
    return (Hit){limit, zero, zero, real_of(0), integer_of(-1), integer_of(0)};
}

/**
 * @return The lanes in which a shape is nearer than the hit so far. At equal distances the shape
 * that comes first in the scene wins, in any order of the tests. NaN is never nearer.
 * @param distance  Distance to the shape.
 * @param shape  Its index in the scene.
 */
INLINE mask hit_is_nearer(const Hit *hit, mask active, real distance, int shape) {
    mask earlier = integer_of(shape) < hit->shape;
    mask tie = (distance == hit->distance) & earlier;
    return active & (distance > 0) & ((distance < hit->distance) | tie);
}

/** Replaces the hits in the lanes in which a shape is nearer. @param found The hits of the shape.
 */
INLINE void hit_update(Hit *hit, mask nearer, const Hit *found) {
    if (LANES > 1 && mask_bits(nearer) == ALL_LANES) {
        hit->distance = found->distance;
        hit->point = found->point;
        hit->normal = found->normal;
        hit->error = found->error;
        hit->shape = found->shape;
        return;
    }
    hit->distance = real_select(nearer, found->distance, hit->distance);
    hit->point = vec3_select(nearer, found->point, hit->point);
    hit->normal = vec3_select(nearer, found->normal, hit->normal);
    hit->error = real_select(nearer, found->error, hit->error);
    hit->shape = integer_select(nearer, found->shape, hit->shape);
}

#endif
