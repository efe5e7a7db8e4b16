/**
 * @file
 * @brief Leaving a surface: from the very point (report C's figures 2 and 4).
 *
 * The point is rounded: it lies as often inside the sphere as outside.
 */
#include "lab/methods/leaving.h"

/** Asks it. See #Method.run. @param question A #LeavingQuestion. @param[out] answer A
 * #LeavingAnswer. */
static void run(const void *question, void *answer) {
    const LeavingQuestion *q = question;
    Leaving leaving = leaving_of(q);
    Second second = {leaving.point, 0};
    *(LeavingAnswer *)answer = leaving_answer(q, &leaving, &second);
}

const Method leaving_none = {.family = "leaving",
                             .name = "no offset",
                             .label = "none",
                             .inputs = NUMBERS_OF(LeavingQuestion),
                             .outputs = NUMBERS_OF(LeavingAnswer),
                             .run = run};
