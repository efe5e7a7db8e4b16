/**
 * @file
 * @brief Leaving a surface: what is nearer than a constant is no meeting.
 *
 * One constant for all scales: too short where numbers are large, too long where things are small.
 */
#include "lab/methods/ray_offset.h"

/** Asks it. See #Method.run. */
static void ray_offset_tmin_run(const void *input, void *output) {
    const RayOffsetInput *in = input;
    RayOffsetHit hit = ray_offset_hit(in);
    RayOffsetStart start = {hit.point, (scalar)1e-4f};
    *(RayOffsetOutput *)output = ray_offset_output_of(in, &hit, &start);
}

const Method ray_offset_tmin = {.group = "leaving",
                                .name = "t > 1e-4",
                                .label = "t > 1e-4",
                                .input_count = NUMBERS_IN(RayOffsetInput),
                                .output_count = NUMBERS_IN(RayOffsetOutput),
                                .run = ray_offset_tmin_run};
