/**
 * @file
 * @brief Share of mirrored light: both polarisations (Fresnel, 1823). The tracer's way.
 *
 *   ((c - n ct) / (c + n ct))^2 and ((n c - ct) / (n c + ct))^2, their mean
 */
#include "lab/methods/fresnel.h"

/** Asks it. See #Method.run. @param question A #FresnelQuestion. @param[out] answer A
 * #FresnelAnswer. */
static void run(const void *question, void *answer) {
    const FresnelQuestion *q = question;
    real squared = refracted_squared(q), c = q->cosine, n = q->index, ct = real_sqrt(squared);
    real along = (c - n * ct) / (c + n * ct), across = (n * c - ct) / (n * c + ct);
    ((FresnelAnswer *)answer)->mirrored = squared > 0 ? (along * along + across * across) / 2 : 1;
}

const Method fresnel_exact = {.family = "fresnel",
                              .name = "exact",
                              .label = "exact",
                              .inputs = NUMBERS_OF(FresnelQuestion),
                              .outputs = NUMBERS_OF(FresnelAnswer),
                              .run = run};
