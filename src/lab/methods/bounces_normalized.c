/**
 * @file
 * @brief Mirrored again and again, made of length 1 each time.
 *
 *   d' = d - 2 (d.n) n, over its length
 */
#include "lab/methods/bounces.h"

/** Asks it. See #Method.run. @param question A #BouncesQuestion. @param[out] answer A
 * #BouncesAnswer. */
static void run(const void *question, void *answer) {
    const BouncesQuestion *q = question;
    Bouncing ray = {q->origin, q->direction, -1};
    for (int i = 0; i < (int)q->count; i++) {
        bounce(q, &ray);
        ray.direction = vector_normalize(ray.direction);
    }
    ((BouncesAnswer *)answer)->direction = ray.direction;
}

const Method bounces_normalized = {.family = "bounces",
                                   .name = "normalized",
                                   .label = "normalized",
                                   .inputs = NUMBERS_OF(BouncesQuestion),
                                   .outputs = NUMBERS_OF(BouncesAnswer),
                                   .run = run};
