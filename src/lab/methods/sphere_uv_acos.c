/**
 * @file
 * @brief Latitude by the arc cosine: report A's way (row A11).
 *
 *   angle = acos((P.y - C.y) / R)
 *
 * At the pole the quotient may be rounded to more than 1, whose arc cosine is no number; and near 1
 * the arc cosine turns the last bit into a large angle.
 */
#include "lab/methods/real_functions.h"
#include "lab/methods/sphere_uv.h"

/** Asks it. See #Method.run. */
static void sphere_uv_acos_run(const void *input, void *output) {
    const SphereUvInput *in = input;
    ((SphereUvOutput *)output)->polar_angle = real_acos((in->point.y - in->center.y) / in->radius);
}

const Method sphere_uv_acos = {.group = "latitude",
                               .name = "acos",
                               .label = "acos",
                               .input_count = NUMBERS_IN(SphereUvInput),
                               .output_count = NUMBERS_IN(SphereUvOutput),
                               .run = sphere_uv_acos_run};
