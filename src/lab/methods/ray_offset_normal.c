/**
 * @file
 * @brief Leaving a surface: a constant along the normal, to the side that the ray goes to.
 *
 *   P + sign(d.N) 1e-4 N
 */
#include "lab/methods/ray_offset.h"

/** Asks it. See #Method.run. */
static void ray_offset_normal_run(const void *input, void *output) {
    const RayOffsetInput *in = input;
    RayOffsetHit hit = ray_offset_hit(in);
    const real epsilon = (scalar)1e-4f;
    real side = vec3_dot(hit.outgoing, hit.normal) > 0 ? epsilon : -epsilon;
    RayOffsetStart start = {vec3_add(hit.point, vec3_scale(hit.normal, side)), 0};
    *(RayOffsetOutput *)output = ray_offset_output_of(in, &hit, &start);
}

const Method ray_offset_normal = {.group = "leaving",
                                  .name = "1e-4 N",
                                  .label = "1e-4 N",
                                  .input_count = NUMBERS_IN(RayOffsetInput),
                                  .output_count = NUMBERS_IN(RayOffsetOutput),
                                  .run = ray_offset_normal_run};
