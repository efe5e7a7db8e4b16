/**
 * @file
 * @brief Leaving a surface: what is nearer than a constant is no meeting.
 *
 * One constant for all scales: too short where numbers are large, too long where things are small.
 */
#include "lab/methods/leaving.h"

/** Asks it. See #Method.run. @param question A #LeavingQuestion. @param[out] answer A
 * #LeavingAnswer. */
static void run(const void *question, void *answer) {
    const LeavingQuestion *q = question;
    Leaving leaving = leaving_of(q);
    Second second = {leaving.point, (scalar)1e-4f};
    *(LeavingAnswer *)answer = leaving_answer(q, &leaving, &second);
}

const Method leaving_tmin = {.family = "leaving",
                             .name = "t > 1e-4",
                             .label = "t > 1e-4",
                             .inputs = NUMBERS_OF(LeavingQuestion),
                             .outputs = NUMBERS_OF(LeavingAnswer),
                             .run = run};
