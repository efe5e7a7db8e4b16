/**
 * @file
 * @brief Rays and hits: the question and the answer of every shape.
 */
#ifndef DIOPTRE_TRACE_TRACER_RAY_H
#define DIOPTRE_TRACE_TRACER_RAY_H

#include "trace/math/vec3.h"

/** LANES rays: the points origin + t * direction with t > 0. The direction has any length but 0. */
typedef struct Ray {
    Vec3 origin;            /**< Where they start. */
    Vec3 direction;         /**< Which way they go. */
    Vec3 inverse_direction; /**< 1 / direction, for slabs; infinite where a component is 0. */
} Ray;

/**
 * What LANES rays have met so far. `is_hit` answers whether, where (point) and with which normal,
 * as in report C.
 */
typedef struct Hit {
    real distance;     /**< The nearest t so far; at first the farthest that counts. */
    Vec3 point;        /**< Where. */
    Vec3 normal;       /**< Unit normal of the surface there, outwards. */
    real error;        /**< Bound on how far #point can be off the surface, scene units. */
    integer shape;     /**< Place of the shape in the scene; -1 while nothing is met. */
    integer primitive; /**< Which part of the shape, where it is a mesh: a slot of its model's
                       blocks. Other shapes leave there what was there. */
} Hit;

/**
 * @return LANES rays.
 * @param direction  Which way, not zero.
 */
INLINE Ray ray_of(Vec3 origin, Vec3 direction) {
    Vec3 inverse = {1 / direction.x, 1 / direction.y, 1 / direction.z};
    return (Ray){origin, direction, inverse};
}

/** @return A hit that has met nothing yet. @param limit The farthest distance that counts. */
INLINE Hit hit_none(real limit) {
    Vec3 zero = {real_of(0), real_of(0), real_of(0)};
    return (Hit){limit, zero, zero, real_of(0), integer_of(-1), integer_of(0)};
}

/**
 * @return The lanes in which a shape is nearer than what was met so far. At the same distance the
 *         shape that comes first in the scene is taken, in every engine and in any order of asking.
 *         A distance that is NaN is not nearer.
 * @param hit  What was met so far.
 * @param distance  Where the shape is met.
 * @param shape  Its place in the scene.
 */
INLINE mask hit_is_nearer(const Hit *hit, mask active, real distance, int shape) {
    mask earlier = integer_of(shape) < hit->shape;
    mask tie = (distance == hit->distance) & earlier;
    return active & (distance > 0) & ((distance < hit->distance) | tie);
}

/**
 * Writes the lanes in which a shape is nearer.
 * @param[in,out] hit  What was met so far.
 * @param found  The new hit; its shape is that of all lanes.
 */
INLINE void hit_update(Hit *hit, mask nearer, const Hit *found) {
    hit->distance = real_select(nearer, found->distance, hit->distance);
    hit->point = vec3_select(nearer, found->point, hit->point);
    hit->normal = vec3_select(nearer, found->normal, hit->normal);
    hit->error = real_select(nearer, found->error, hit->error);
    hit->shape = integer_select(nearer, found->shape, hit->shape);
}

#endif
