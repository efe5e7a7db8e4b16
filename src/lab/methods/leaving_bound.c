/**
 * @file
 * @brief Leaving a surface: a bound on the rounding error, along the normal.
 *
 *   P + sign(d.N) 32 u (|P| + R) N, u half an ulp of 1
 *
 * As large as the coordinates make it, and no larger. The tracer's own bounds are like it.
 */
#include "lab/methods/leaving.h"

/** Asks it. See #Method.run. @param question A #LeavingQuestion. @param[out] answer A
 * #LeavingAnswer. */
static void run(const void *question, void *answer) {
    const LeavingQuestion *q = question;
    Leaving leaving = leaving_of(q);
    real far = 32 * ROUNDOFF * (vector_largest(leaving.point) + q->radius);
    real side = vector_dot(leaving.direction, leaving.normal) > 0 ? far : -far;
    Second second = {vector_add(leaving.point, vector_scale(leaving.normal, side)), 0};
    *(LeavingAnswer *)answer = leaving_answer(q, &leaving, &second);
}

const Method leaving_bound = {.family = "leaving",
                              .name = "32 u (|P| + R) N",
                              .label = "bound",
                              .inputs = NUMBERS_OF(LeavingQuestion),
                              .outputs = NUMBERS_OF(LeavingAnswer),
                              .run = run};
