/**
 * @file
 * @brief Normal of a distance field: central differences.
 *
 *   f(P + h ex) - f(P - h ex) and so on: six values, an error of the order of h^2
 */
#include "lab/methods/gradient.h"

/** Asks it. See #Method.run. @param question A #GradientQuestion. @param[out] answer A
 * #GradientAnswer. */
static void run(const void *question, void *answer) {
    const GradientQuestion *q = question;
    real h = q->step;
    Vector n = {field_at(q, h, 0, 0) - field_at(q, -h, 0, 0),
                field_at(q, 0, h, 0) - field_at(q, 0, -h, 0),
                field_at(q, 0, 0, h) - field_at(q, 0, 0, -h)};
    ((GradientAnswer *)answer)->normal = vector_normalize(n);
}

const Method gradient_central = {.family = "gradient",
                                 .name = "central",
                                 .label = "central",
                                 .inputs = NUMBERS_OF(GradientQuestion),
                                 .outputs = NUMBERS_OF(GradientAnswer),
                                 .run = run};
