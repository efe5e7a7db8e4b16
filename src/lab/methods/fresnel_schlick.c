/**
 * @file
 * @brief Share of mirrored light: the usual approximation (Schlick, *An Inexpensive BRDF Model
 *        for Physically-based Rendering*, Computer Graphics Forum 1994).
 *
 *   R0 + (1 - R0) (1 - c)^5,  R0 = ((n - 1) / (n + 1))^2,  c on the side of the lower index
 */
#include "lab/methods/fresnel.h"

/** Asks it. See #Method.run. */
static void fresnel_schlick_run(const void *input, void *output) {
    const FresnelInput *in = input;
    real cosine_t_squared = fresnel_cosine_t_squared(in), root = (in->index - 1) / (in->index + 1);
    real c = in->index < 1 ? real_sqrt(cosine_t_squared) : in->cosine, m = 1 - c, r0 = root * root;
    ((FresnelOutput *)output)->reflectance =
        cosine_t_squared > 0 ? r0 + (1 - r0) * m * m * m * m * m : 1;
}

const Method fresnel_schlick = {.group = "fresnel",
                                .name = "Schlick",
                                .label = "Schlick",
                                .input_count = NUMBERS_IN(FresnelInput),
                                .output_count = NUMBERS_IN(FresnelOutput),
                                .run = fresnel_schlick_run};
