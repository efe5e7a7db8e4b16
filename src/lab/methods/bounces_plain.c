/**
 * @file
 * @brief Mirrored again and again, as the formula gives it.
 *
 *   d' = d - 2 (d.n) n
 *
 * The length of d drifts by a rounding each time, which is little beside what curved mirrors make
 * of an angle: about 2.5 times as much each time.
 */
#include "lab/methods/bounces.h"

/** Asks it. See #Method.run. */
static void bounces_plain_run(const void *input, void *output) {
    const BouncesInput *in = input;
    BounceRay ray = {in->origin, in->direction, -1};
    for (int i = 0; i < (int)in->bounce_count; i++) {
        bounces_reflect(in, &ray);
    }
    ((BouncesOutput *)output)->direction = ray.direction;
}

const Method bounces_plain = {.group = "bounces",
                              .name = "plain",
                              .label = "plain",
                              .input_count = NUMBERS_IN(BouncesInput),
                              .output_count = NUMBERS_IN(BouncesOutput),
                              .run = bounces_plain_run};
