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

/** Asks it. See #Method.run. @param question A #BouncesQuestion. @param[out] answer A
 * #BouncesAnswer. */
static void run(const void *question, void *answer) {
    const BouncesQuestion *q = question;
    Bouncing ray = {q->origin, q->direction, -1};
    for (int i = 0; i < (int)q->count; i++) {
        bounce(q, &ray);
    }
    ((BouncesAnswer *)answer)->direction = ray.direction;
}

const Method bounces_plain = {.family = "bounces",
                              .name = "plain",
                              .label = "plain",
                              .inputs = NUMBERS_OF(BouncesQuestion),
                              .outputs = NUMBERS_OF(BouncesAnswer),
                              .run = run};
