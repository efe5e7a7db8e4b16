/**
 * @file
 * @brief Leaving a surface: a bound on the rounding error, along the normal.
 *
 *   P + sign(d.N) 32 u (|P| + R) N, u half an ulp of 1
 *
 * As large as the coordinates make it, and no larger. The tracer's own bounds are like it.
 */
#include "lab/methods/ray_offset.h"

/** Asks it. See #Method.run. */
static void ray_offset_error_bound_run(const void *input, void *output) {
    const RayOffsetInput *in = input;
    RayOffsetHit hit = ray_offset_hit(in);
    real offset = 32 * ROUNDOFF * (vec3_max_abs(hit.point) + in->radius);
    real side = vec3_dot(hit.outgoing, hit.normal) > 0 ? offset : -offset;
    RayOffsetStart start = {vec3_add(hit.point, vec3_scale(hit.normal, side)), 0};
    *(RayOffsetOutput *)output = ray_offset_output_of(in, &hit, &start);
}

const Method ray_offset_error_bound = {.group = "leaving",
                                       .name = "32 u (|P| + R) N",
                                       .label = "bound",
                                       .input_count = NUMBERS_IN(RayOffsetInput),
                                       .output_count = NUMBERS_IN(RayOffsetOutput),
                                       .run = ray_offset_error_bound_run};
