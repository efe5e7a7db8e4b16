/**
 * @file
 * @brief Plain marching (Hart, *Sphere Tracing: A Geometric Method for the Antialiased Ray Tracing
 *        of Implicit Surfaces*, 1996), as in report B (row B1).
 *
 *   t = t + f(P0 + t d) until f < tolerance
 */
#include "lab/methods/marching.h"

/** Asks it. See #Method.run. @param question A #MarchingQuestion. @param[out] answer A
 * #MarchingAnswer. */
static void run(const void *question, void *answer) {
    const MarchingQuestion *q = question;
    MarchingAnswer *found = answer;
    *found = (MarchingAnswer){.distance = INFINITE};
    real t = 0;
    for (int i = 1; i <= MARCHING_STEPS; i++) {
        real height = height_at(q, t);
        if (height < q->tolerance) {
            *found = (MarchingAnswer){t, (real)i};
            return;
        }
        t += height;
    }
}

const Method marching_plain = {.family = "marching",
                               .name = "plain",
                               .label = "plain",
                               .inputs = NUMBERS_OF(MarchingQuestion),
                               .outputs = NUMBERS_OF(MarchingAnswer),
                               .run = run};
