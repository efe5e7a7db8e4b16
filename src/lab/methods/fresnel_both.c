/**
 * @file
 * @brief The mirrored share of light that is not polarised, by whichever of two shares is smaller.
 *
 * What is mirrored is ((c - n ct) / (c + n ct))^2 and its twin, halved (fresnel_exact.c); what is
 * let through is 4 c n ct / (c + n ct)^2 and its twin, halved. The two make 1. Near the surface
 * nearly all is mirrored, and its square has seven roundings of a number near 1; what is let
 * through has as many, of a small one, and 1 less that has one rounding more.
 */
#include "lab/methods/fresnel.h"

/** Answers a question. See #Method.run. @param question A #FresnelQuestion. @param[out] answer A
 * #FresnelAnswer. */
static void run(const void *question, void *answer) {
    const FresnelQuestion *q = question;
    real squared = refracted_squared(q), c = q->cosine, n = q->index, ct = real_sqrt(squared);
    real along = c + n * ct, across = n * c + ct;
    real less_along = (c - n * ct) / along, less_across = (n * c - ct) / across;
    real mirrored = (less_along * less_along + less_across * less_across) / 2;
    real through = 2 * c * n * ct * (1 / (along * along) + 1 / (across * across));
    real share = mirrored < through ? mirrored : 1 - through;
    ((FresnelAnswer *)answer)->mirrored = squared > 0 ? share : 1;
}

const Method fresnel_both = {.family = "fresnel",
                             .name = "exact by both shares",
                             .label = "both shares",
                             .inputs = NUMBERS_OF(FresnelQuestion),
                             .outputs = NUMBERS_OF(FresnelAnswer),
                             .run = run};
