/**
 * @file
 * @brief Normal of a distance field: forward differences, as in report B (row B3).
 *
 *   f(P + h ex) - f(P) and so on: four values, an error of the order of h
 */
#include "lab/methods/gradient.h"

/** Asks it. See #Method.run. */
static void gradient_forward_run(const void *input, void *output) {
    const GradientInput *in = input;
    real h = in->step, here = gradient_sphere_sdf(in, 0, 0, 0);
    Vec3 n = {gradient_sphere_sdf(in, h, 0, 0) - here, gradient_sphere_sdf(in, 0, h, 0) - here,
              gradient_sphere_sdf(in, 0, 0, h) - here};
    ((GradientOutput *)output)->normal = vec3_normalize(n);
}

const Method gradient_forward = {.group = "gradient",
                                 .name = "forward",
                                 .label = "forward",
                                 .input_count = NUMBERS_IN(GradientInput),
                                 .output_count = NUMBERS_IN(GradientOutput),
                                 .run = gradient_forward_run};
