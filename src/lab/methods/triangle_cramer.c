/**
 * @file
 * @brief Triangle by Cramer's rule: report A's way (row A7).
 *
 *   (b - a  c - a  -d) (u v t)' = P0 - a, each unknown as a quotient of two 3 x 3 determinants
 *
 * The triangles on the two sides of an edge compute its u, v or u + v from different differences,
 * and round them differently: a ray at the edge may miss both.
 */
#include "lab/methods/triangle.h"

/** @return The determinant of three columns. @param a The first. @param b The second. @param c The
 *  third. */
static real determinant_of(Vector a, Vector b, Vector c) {
    return a.x * (b.y * c.z - b.z * c.y) - b.x * (a.y * c.z - a.z * c.y) +
           c.x * (a.y * b.z - a.z * b.y);
}

/** Asks it. See #Method.run. @param question A #TriangleQuestion. @param[out] answer A
 * #TriangleAnswer. */
static void run(const void *question, void *answer) {
    const TriangleQuestion *q = question;
    Vector e1 = vector_subtract(q->b, q->a), e2 = vector_subtract(q->c, q->a);
    Vector s = vector_subtract(q->origin, q->a), back = vector_scale(q->direction, -1);
    real determinant = determinant_of(e1, e2, back);
    real u = determinant_of(s, e2, back) / determinant;
    real v = determinant_of(e1, s, back) / determinant;
    real t = determinant_of(e1, e2, s) / determinant;
    int is_met = determinant != 0 && u >= 0 && v >= 0 && u + v <= 1 && t > 0;
    ((TriangleAnswer *)answer)->distance = is_met ? t : INFINITE;
}

const Method triangle_cramer = {.family = "triangle",
                                .name = "Cramer",
                                .label = "Cramer",
                                .inputs = NUMBERS_OF(TriangleQuestion),
                                .outputs = NUMBERS_OF(TriangleAnswer),
                                .run = run};
