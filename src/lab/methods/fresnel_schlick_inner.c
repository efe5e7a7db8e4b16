/**
 * @file
 * @brief Share of mirrored light: Schlick's approximation with the ray's own cosine on both
 *        sides.
 *
 *   R0 + (1 - R0) (1 - c)^5, c of the ray that comes, inside the glass, too
 *
 * From inside it stays low up to the critical angle, and then jumps to 1.
 */
#include "lab/methods/fresnel.h"

/** Asks it. See #Method.run. @param question A #FresnelQuestion. @param[out] answer A
 * #FresnelAnswer. */
static void run(const void *question, void *answer) {
    const FresnelQuestion *q = question;
    real squared = refracted_squared(q), root = (q->index - 1) / (q->index + 1);
    real m = 1 - q->cosine, r0 = root * root;
    ((FresnelAnswer *)answer)->mirrored = squared > 0 ? r0 + (1 - r0) * m * m * m * m * m : 1;
}

const Method fresnel_schlick_inner = {.family = "fresnel",
                                      .name = "Schlick by the inner cosine",
                                      .label = "inner cosine",
                                      .inputs = NUMBERS_OF(FresnelQuestion),
                                      .outputs = NUMBERS_OF(FresnelAnswer),
                                      .run = run};
