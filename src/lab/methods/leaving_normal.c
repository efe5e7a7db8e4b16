/**
 * @file
 * @brief Leaving a surface: a constant along the normal, to the side that the ray goes to.
 *
 *   P + sign(d.N) 1e-4 N
 */
#include "lab/methods/leaving.h"

/** Asks it. See #Method.run. @param question A #LeavingQuestion. @param[out] answer A
 * #LeavingAnswer. */
static void run(const void *question, void *answer) {
    const LeavingQuestion *q = question;
    Leaving leaving = leaving_of(q);
    const real epsilon = (scalar)1e-4f;
    real side = vector_dot(leaving.direction, leaving.normal) > 0 ? epsilon : -epsilon;
    Second second = {vector_add(leaving.point, vector_scale(leaving.normal, side)), 0};
    *(LeavingAnswer *)answer = leaving_answer(q, &leaving, &second);
}

const Method leaving_normal = {.family = "leaving",
                               .name = "1e-4 N",
                               .label = "1e-4 N",
                               .inputs = NUMBERS_OF(LeavingQuestion),
                               .outputs = NUMBERS_OF(LeavingAnswer),
                               .run = run};
