/**
 * @file
 * @brief Latitude by the arc tangent of its two legs: the tracer's way.
 *
 *   angle = atan2(sqrt(x^2 + z^2), y), of P - C
 */
#include "lab/methods/real_functions.h"
#include "lab/methods/sphere_uv.h"

/** Asks it. See #Method.run. */
static void sphere_uv_atan2_run(const void *input, void *output) {
    const SphereUvInput *in = input;
    Vec3 n = vec3_subtract(in->point, in->center);
    ((SphereUvOutput *)output)->polar_angle = real_atan2(real_sqrt(n.x * n.x + n.z * n.z), n.y);
}

const Method sphere_uv_atan2 = {.group = "latitude",
                                .name = "atan2",
                                .label = "atan2",
                                .input_count = NUMBERS_IN(SphereUvInput),
                                .output_count = NUMBERS_IN(SphereUvOutput),
                                .run = sphere_uv_atan2_run};
