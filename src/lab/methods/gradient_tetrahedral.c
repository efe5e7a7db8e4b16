/**
 * @file
 * @brief Normal of a distance field: at the corners of a tetrahedron (Quilez, *Normals for an SDF*,
 *        2015).
 *
 *   the sum of k f(P + h k) over k = (+--), (--+), (-+-), (+++)
 *
 * Four values. What two differences cancel in central ones, the mixed second derivatives, stays
 * here: an error of the order of h.
 */
#include "lab/methods/gradient.h"

/** Asks it. See #Method.run. @param question A #GradientQuestion. @param[out] answer A
 * #GradientAnswer. */
static void run(const void *question, void *answer) {
    const GradientQuestion *q = question;
    real h = q->step, a = field_at(q, h, -h, -h), b = field_at(q, -h, -h, h);
    real c = field_at(q, -h, h, -h), d = field_at(q, h, h, h);
    Vector n = {a - b - c + d, -a - b + c + d, -a + b - c + d};
    ((GradientAnswer *)answer)->normal = vector_normalize(n);
}

const Method gradient_tetrahedral = {.family = "gradient",
                                     .name = "tetrahedral",
                                     .label = "tetrahedral",
                                     .inputs = NUMBERS_OF(GradientQuestion),
                                     .outputs = NUMBERS_OF(GradientAnswer),
                                     .run = run};
