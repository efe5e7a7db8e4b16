/**
 * @file
 * @brief Normal of a distance field: its gradient in closed form.
 *
 *   (P - C) / |P - C|
 */
#include "lab/methods/gradient.h"

/** Asks it. See #Method.run. @param question A #GradientQuestion. @param[out] answer A
 * #GradientAnswer. */
static void run(const void *question, void *answer) {
    const GradientQuestion *q = question;
    ((GradientAnswer *)answer)->normal = vector_normalize(vector_subtract(q->point, q->center));
}

const Method gradient_exact = {.family = "gradient",
                               .name = "exact",
                               .label = "exact",
                               .inputs = NUMBERS_OF(GradientQuestion),
                               .outputs = NUMBERS_OF(GradientAnswer),
                               .run = run};
