/**
 * @file
 * @brief Does a ray meet a triangle, and where? What is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_TRIANGLE_H
#define DIOPTRE_LAB_METHODS_TRIANGLE_H

#include "lab/methods/method.h"
#include "trace/math/vec3.h"

/** A ray and a triangle. */
typedef struct TriangleInput {
    Vec3 origin;    /**< Where the ray starts: P0. */
    Vec3 direction; /**< Which way: d. */
    Vec3 a;         /**< A corner. */
    Vec3 b;         /**< Another. */
    Vec3 c;         /**< The third. */
} TriangleInput;

/** Where it is met. */
typedef struct TriangleOutput {
    real distance; /**< In lengths of the direction; #INFINITE: not at all. */
} TriangleOutput;

/** @return a x b. */
static inline Vec3 triangle_cross(Vec3 a, Vec3 b) {
    return (Vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** What Möller and Trumbore solve for. */
typedef struct TriangleSolution {
    real determinant; /**< Of the three equations; 0 where the ray runs along the triangle. */
    real u;           /**< Share of b. */
    real v;           /**< Share of c. */
    real distance;    /**< How far. */
} TriangleSolution;

/** @return The solution of P0 + t d = a + u (b - a) + v (c - a) by four triple products (Möller,
 *  Trumbore, *Fast, Minimum Storage Ray/Triangle Intersection*, Journal of Graphics Tools 1997). */
static inline TriangleSolution triangle_moller_trumbore_solve(const TriangleInput *in) {
    Vec3 e1 = vec3_subtract(in->b, in->a), e2 = vec3_subtract(in->c, in->a);
    Vec3 p = triangle_cross(in->direction, e2), s = vec3_subtract(in->origin, in->a),
         r = triangle_cross(s, e1);
    real determinant = vec3_dot(e1, p), inverse = 1 / determinant;
    return (TriangleSolution){determinant, vec3_dot(s, p) * inverse,
                              vec3_dot(in->direction, r) * inverse, vec3_dot(e2, r) * inverse};
}

#endif
