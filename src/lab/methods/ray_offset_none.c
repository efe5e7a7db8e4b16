/**
 * @file
 * @brief Leaving a surface: from the very point (report C's figures 2 and 4).
 *
 * The point is rounded: it lies as often inside the sphere as outside.
 */
#include "lab/methods/ray_offset.h"

/** Asks it. See #Method.run. */
static void ray_offset_none_run(const void *input, void *output) {
    const RayOffsetInput *in = input;
    RayOffsetHit hit = ray_offset_hit(in);
    RayOffsetStart start = {hit.point, 0};
    *(RayOffsetOutput *)output = ray_offset_output_of(in, &hit, &start);
}

const Method ray_offset_none = {.group = "leaving",
                                .name = "no offset",
                                .label = "none",
                                .input_count = NUMBERS_IN(RayOffsetInput),
                                .output_count = NUMBERS_IN(RayOffsetOutput),
                                .run = ray_offset_none_run};
