/**
 * @file
 * @brief Normal of a distance field: central differences.
 *
 *   f(P + h ex) - f(P - h ex) and so on: six values, an error of the order of h^2
 */
#include "lab/methods/gradient.h"

/** Asks it. See #Method.run. */
static void gradient_central_run(const void *input, void *output) {
    const GradientInput *in = input;
    real h = in->step;
    Vec3 n = {gradient_sphere_sdf(in, h, 0, 0) - gradient_sphere_sdf(in, -h, 0, 0),
              gradient_sphere_sdf(in, 0, h, 0) - gradient_sphere_sdf(in, 0, -h, 0),
              gradient_sphere_sdf(in, 0, 0, h) - gradient_sphere_sdf(in, 0, 0, -h)};
    ((GradientOutput *)output)->normal = vec3_normalize(n);
}

const Method gradient_central = {.group = "gradient",
                                 .name = "central",
                                 .label = "central",
                                 .input_count = NUMBERS_IN(GradientInput),
                                 .output_count = NUMBERS_IN(GradientOutput),
                                 .run = gradient_central_run};
