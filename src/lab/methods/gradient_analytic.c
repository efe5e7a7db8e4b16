/**
 * @file
 * @brief Normal of a distance field: its gradient in closed form.
 *
 *   (P - C) / |P - C|
 */
#include "lab/methods/gradient.h"

/** Asks it. See #Method.run. */
static void gradient_analytic_run(const void *input, void *output) {
    const GradientInput *in = input;
    ((GradientOutput *)output)->normal = vec3_normalize(vec3_subtract(in->point, in->center));
}

const Method gradient_analytic = {.group = "gradient",
                                  .name = "exact",
                                  .label = "exact",
                                  .input_count = NUMBERS_IN(GradientInput),
                                  .output_count = NUMBERS_IN(GradientOutput),
                                  .run = gradient_analytic_run};
