/**
 * @file
 * @brief Leaving a surface: a constant along the normal, outwards: report C's rule for shadows (row
 * C4), used for all rays.
 *
 *   P + 1e-4 N
 *
 * Right for shadows and mirrors. A ray that goes into glass starts before the surface that it has
 * just met, and meets it again: the transparent sphere that report A could not draw.
 */
#include "lab/methods/leaving.h"

/** Asks it. See #Method.run. @param question A #LeavingQuestion. @param[out] answer A
 * #LeavingAnswer. */
static void run(const void *question, void *answer) {
    const LeavingQuestion *q = question;
    Leaving leaving = leaving_of(q);
    const real epsilon = (scalar)1e-4f;
    Second second = {vector_add(leaving.point, vector_scale(leaving.normal, epsilon)), 0};
    *(LeavingAnswer *)answer = leaving_answer(q, &leaving, &second);
}

const Method leaving_outwards = {.family = "leaving",
                                 .name = "1e-4 N outwards",
                                 .label = "outwards",
                                 .inputs = NUMBERS_OF(LeavingQuestion),
                                 .outputs = NUMBERS_OF(LeavingAnswer),
                                 .run = run};
