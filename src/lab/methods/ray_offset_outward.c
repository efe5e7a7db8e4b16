/**
 * @file
 * @brief Leaving a surface: a constant along the normal, outwards: report C's rule for shadows (row
 * C4), used for all rays.
 *
 *   P + 1e-4 N
 *
 * Right for shadows and mirrors. A ray that goes into glass starts before the surface that it has
 * just met, and meets it again: the transparent sphere that report A could not draw.
 */
#include "lab/methods/ray_offset.h"

/** Asks it. See #Method.run. */
static void ray_offset_outward_run(const void *input, void *output) {
    const RayOffsetInput *in = input;
    RayOffsetHit hit = ray_offset_hit(in);
    const real epsilon = (scalar)1e-4f;
    RayOffsetStart start = {vec3_add(hit.point, vec3_scale(hit.normal, epsilon)), 0};
    *(RayOffsetOutput *)output = ray_offset_output_of(in, &hit, &start);
}

const Method ray_offset_outward = {.group = "leaving",
                                   .name = "1e-4 N outwards",
                                   .label = "outwards",
                                   .input_count = NUMBERS_IN(RayOffsetInput),
                                   .output_count = NUMBERS_IN(RayOffsetOutput),
                                   .run = ray_offset_outward_run};
