/**
 * @file
 * @brief Plane by its offset D, worked out once.
 *
 *   D = N.Q,  t = (D - N.P0) / d.N
 */
#include "lab/methods/plane.h"

/** Asks it. See #Method.run. */
static void plane_equation_run(const void *input, void *output) {
    const PlaneInput *in = input;
    real height = in->offset - vec3_dot(in->normal, in->origin);
    ((PlaneOutput *)output)->distance = height / vec3_dot(in->direction, in->normal);
}

const Method plane_equation = {.group = "plane",
                               .name = "by its offset",
                               .label = "by its offset",
                               .input_count = NUMBERS_IN(PlaneInput),
                               .output_count = NUMBERS_IN(PlaneOutput),
                               .run = plane_equation_run};
