/**
 * @file
 * @brief Triangle by the signed volumes of the ray with its three edges (Kensler, Shirley,
 *        *Optimizing Ray-Triangle Intersection via Automated Search*, 2006).
 *
 *   w_ab = d.((a - P0) x (b - P0)) and so on; all of one sign: inside
 *
 * Two neighbours compute the same product for the edge that they share, with opposite signs, so
 * that no ray passes between them. At a corner three edges or more meet, and theirs do not agree.
 */
#include "lab/methods/triangle.h"

/** Asks it. See #Method.run. @param question A #TriangleQuestion. @param[out] answer A
 * #TriangleAnswer. */
static void run(const void *question, void *answer) {
    const TriangleQuestion *q = question;
    Vector a = vector_subtract(q->a, q->origin), b = vector_subtract(q->b, q->origin);
    Vector c = vector_subtract(q->c, q->origin), d = q->direction;
    real at_c = vector_dot(d, cross(a, b)), at_a = vector_dot(d, cross(b, c));
    real at_b = vector_dot(d, cross(c, a)), sum = at_a + at_b + at_c;
    int is_inside = (at_a >= 0 && at_b >= 0 && at_c >= 0) || (at_a <= 0 && at_b <= 0 && at_c <= 0);
    Vector normal = cross(vector_subtract(b, a), vector_subtract(c, a));
    real t = vector_dot(a, normal) / vector_dot(d, normal);
    ((TriangleAnswer *)answer)->distance = is_inside && sum != 0 && t > 0 ? t : INFINITE;
}

const Method triangle_volumes = {.family = "triangle",
                                 .name = "signed volumes",
                                 .label = "volumes",
                                 .inputs = NUMBERS_OF(TriangleQuestion),
                                 .outputs = NUMBERS_OF(TriangleAnswer),
                                 .run = run};
