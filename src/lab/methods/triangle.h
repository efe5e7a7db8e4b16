/**
 * @file
 * @brief Does a ray meet a triangle, and where? What is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_TRIANGLE_H
#define DIOPTRE_LAB_METHODS_TRIANGLE_H

#include "lab/methods/method.h"
#include "trace/vector.h"

/** A ray and a triangle. */
typedef struct TriangleQuestion {
    Vector origin;    /**< Where the ray starts: P0. */
    Vector direction; /**< Which way: d. */
    Vector a;         /**< A corner. */
    Vector b;         /**< Another. */
    Vector c;         /**< The third. */
} TriangleQuestion;

/** Where it is met. */
typedef struct TriangleAnswer {
    real distance; /**< In lengths of the direction; #INFINITE: not at all. */
} TriangleAnswer;

/** @return a x b. @param a A vector. @param b Another. */
static inline Vector cross(Vector a, Vector b) {
    return (Vector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** What Möller and Trumbore solve for. */
typedef struct Barycentric {
    real determinant; /**< Of the three equations; 0 where the ray runs along the triangle. */
    real u;           /**< Share of b. */
    real v;           /**< Share of c. */
    real distance;    /**< How far. */
} Barycentric;

/**
 * @return The solution of P0 + t d = a + u (b - a) + v (c - a) by four triple products (Möller,
 *         Trumbore, *Fast, Minimum Storage Ray/Triangle Intersection*, Journal of Graphics Tools
 *         1997).
 * @param q  The question.
 */
static inline Barycentric moeller_trumbore(const TriangleQuestion *q) {
    Vector e1 = vector_subtract(q->b, q->a), e2 = vector_subtract(q->c, q->a);
    Vector p = cross(q->direction, e2), s = vector_subtract(q->origin, q->a), r = cross(s, e1);
    real determinant = vector_dot(e1, p), inverse = 1 / determinant;
    return (Barycentric){determinant, vector_dot(s, p) * inverse,
                         vector_dot(q->direction, r) * inverse, vector_dot(e2, r) * inverse};
}

#endif
