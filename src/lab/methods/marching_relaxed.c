/**
 * @file
 * @brief Marching with longer steps (Keinert and others, *Enhanced Sphere Tracing*, 2014): the
 *        tracer's way.
 *
 *   t = t + w f, w = 1.6, taken back where the balls around two points in turn do not touch
 */
#include "lab/methods/marching.h"

/** Asks it. See #Method.run. @param question A #MarchingQuestion. @param[out] answer A
 * #MarchingAnswer. */
static void run(const void *question, void *answer) {
    const MarchingQuestion *q = question;
    const real longer = (scalar)1.6f;
    MarchingAnswer *found = answer;
    *found = (MarchingAnswer){.distance = INFINITE};
    real t = 0, before = 0, step = 0, factor = longer;
    for (int i = 1; i <= MARCHING_STEPS; i++) {
        real height = height_at(q, t);
        if (factor > 1 && before + real_abs(height) < step) {
            // Something may lie between the two balls: back to the end of the safe step.
            t += before - step;
            factor = 1;
            step = before;
            continue;
        }
        if (height < q->tolerance) {
            *found = (MarchingAnswer){t, (real)i};
            return;
        }
        step = factor * height;
        before = height;
        t += step;
    }
}

const Method marching_relaxed = {.family = "marching",
                                 .name = "relaxed",
                                 .label = "relaxed",
                                 .inputs = NUMBERS_OF(MarchingQuestion),
                                 .outputs = NUMBERS_OF(MarchingAnswer),
                                 .run = run};
