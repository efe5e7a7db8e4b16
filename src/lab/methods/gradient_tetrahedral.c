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

/** Asks it. See #Method.run. */
static void gradient_tetrahedral_run(const void *input, void *output) {
    const GradientInput *in = input;
    real h = in->step, a = gradient_sphere_sdf(in, h, -h, -h),
         b = gradient_sphere_sdf(in, -h, -h, h);
    real c = gradient_sphere_sdf(in, -h, h, -h), d = gradient_sphere_sdf(in, h, h, h);
    Vec3 n = {a - b - c + d, -a - b + c + d, -a + b - c + d};
    ((GradientOutput *)output)->normal = vec3_normalize(n);
}

const Method gradient_tetrahedral = {.group = "gradient",
                                     .name = "tetrahedral",
                                     .label = "tetrahedral",
                                     .input_count = NUMBERS_IN(GradientInput),
                                     .output_count = NUMBERS_IN(GradientOutput),
                                     .run = gradient_tetrahedral_run};
