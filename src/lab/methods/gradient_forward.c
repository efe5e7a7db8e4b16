/**
 * @file
 * @brief Normal of a distance field: forward differences, as in report B (row B3).
 *
 *   f(P + h ex) - f(P) and so on: four values, an error of the order of h
 */
#include "lab/methods/gradient.h"

/** Asks it. See #Method.run. @param question A #GradientQuestion. @param[out] answer A
 * #GradientAnswer. */
static void run(const void *question, void *answer) {
    const GradientQuestion *q = question;
    real h = q->step, here = field_at(q, 0, 0, 0);
    Vector n = {field_at(q, h, 0, 0) - here, field_at(q, 0, h, 0) - here,
                field_at(q, 0, 0, h) - here};
    ((GradientAnswer *)answer)->normal = vector_normalize(n);
}

const Method gradient_forward = {.family = "gradient",
                                 .name = "forward",
                                 .label = "forward",
                                 .inputs = NUMBERS_OF(GradientQuestion),
                                 .outputs = NUMBERS_OF(GradientAnswer),
                                 .run = run};
