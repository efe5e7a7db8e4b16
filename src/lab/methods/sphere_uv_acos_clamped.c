/**
 * @file
 * @brief Latitude by the arc cosine of what is held between -1 and 1.
 *
 *   angle = acos(min(1, max(-1, (P.y - C.y) / R)))
 *
 * No NaN any more; the last bit still counts as much.
 */
#include "lab/methods/real_functions.h"
#include "lab/methods/sphere_uv.h"

/** Asks it. See #Method.run. */
static void sphere_uv_acos_clamped_run(const void *input, void *output) {
    const SphereUvInput *in = input;
    real y = (in->point.y - in->center.y) / in->radius;
    y = y > 1 ? 1 : y < -1 ? -1 : y;
    ((SphereUvOutput *)output)->polar_angle = real_acos(y);
}

const Method sphere_uv_acos_clamped = {.group = "latitude",
                                       .name = "acos held",
                                       .label = "acos held",
                                       .input_count = NUMBERS_IN(SphereUvInput),
                                       .output_count = NUMBERS_IN(SphereUvOutput),
                                       .run = sphere_uv_acos_clamped_run};
