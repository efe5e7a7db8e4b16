/**
 * @file
 * @brief Share of mirrored light: one polarisation only, as in report D (row D3).
 *
 *   ((c - n ct) / (c + n ct))^2 for light that swings along the surface
 *
 * Daylight swings every way: it is the mean of two such terms.
 */
#include "lab/methods/fresnel.h"

/** Asks it. See #Method.run. @param question A #FresnelQuestion. @param[out] answer A
 * #FresnelAnswer. */
static void run(const void *question, void *answer) {
    const FresnelQuestion *q = question;
    real squared = refracted_squared(q), c = q->cosine, ct = q->index * real_sqrt(squared);
    real along = (c - ct) / (c + ct);
    ((FresnelAnswer *)answer)->mirrored = squared > 0 ? along * along : 1;
}

const Method fresnel_one = {.family = "fresnel",
                            .name = "one polarisation",
                            .label = "one polarisation",
                            .inputs = NUMBERS_OF(FresnelQuestion),
                            .outputs = NUMBERS_OF(FresnelAnswer),
                            .run = run};
