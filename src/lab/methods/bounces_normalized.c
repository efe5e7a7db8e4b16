/**
 * @file
 * @brief Mirrored again and again, made of length 1 each time.
 *
 *   d' = d - 2 (d.n) n, over its length
 */
#include "lab/methods/bounces.h"

/** Asks it. See #Method.run. */
static void bounces_normalized_run(const void *input, void *output) {
    const BouncesInput *in = input;
    BounceRay ray = {in->origin, in->direction, -1};
    for (int i = 0; i < (int)in->bounce_count; i++) {
        bounces_reflect(in, &ray);
        ray.direction = vec3_normalize(ray.direction);
    }
    ((BouncesOutput *)output)->direction = ray.direction;
}

const Method bounces_normalized = {.group = "bounces",
                                   .name = "normalized",
                                   .label = "normalized",
                                   .input_count = NUMBERS_IN(BouncesInput),
                                   .output_count = NUMBERS_IN(BouncesOutput),
                                   .run = bounces_normalized_run};
