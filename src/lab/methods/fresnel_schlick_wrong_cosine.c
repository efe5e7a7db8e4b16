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

/** Asks it. See #Method.run. */
static void fresnel_schlick_wrong_cosine_run(const void *input, void *output) {
    const FresnelInput *in = input;
    real cosine_t_squared = fresnel_cosine_t_squared(in), root = (in->index - 1) / (in->index + 1);
    real m = 1 - in->cosine, r0 = root * root;
    ((FresnelOutput *)output)->reflectance =
        cosine_t_squared > 0 ? r0 + (1 - r0) * m * m * m * m * m : 1;
}

const Method fresnel_schlick_wrong_cosine = {.group = "fresnel",
                                             .name = "Schlick by the inner cosine",
                                             .label = "inner cosine",
                                             .input_count = NUMBERS_IN(FresnelInput),
                                             .output_count = NUMBERS_IN(FresnelOutput),
                                             .run = fresnel_schlick_wrong_cosine_run};
