/**
 * @file
 * @brief Share of mirrored light: the usual approximation (Schlick, *An Inexpensive BRDF Model
 *        for Physically-based Rendering*, Computer Graphics Forum 1994).
 *
 *   R0 + (1 - R0) (1 - c)^5,  R0 = ((n - 1) / (n + 1))^2,  c on the side of the lower index
 */
#include "lab/methods/fresnel.h"

/** Asks it. See #Method.run. @param question A #FresnelQuestion. @param[out] answer A
 * #FresnelAnswer. */
static void run(const void *question, void *answer) {
    const FresnelQuestion *q = question;
    real squared = refracted_squared(q), root = (q->index - 1) / (q->index + 1);
    real c = q->index < 1 ? real_sqrt(squared) : q->cosine, m = 1 - c, r0 = root * root;
    ((FresnelAnswer *)answer)->mirrored = squared > 0 ? r0 + (1 - r0) * m * m * m * m * m : 1;
}

const Method fresnel_schlick = {.family = "fresnel",
                                .name = "Schlick",
                                .label = "Schlick",
                                .inputs = NUMBERS_OF(FresnelQuestion),
                                .outputs = NUMBERS_OF(FresnelAnswer),
                                .run = run};
