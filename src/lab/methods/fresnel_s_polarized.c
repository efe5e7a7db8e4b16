/**
 * @file
 * @brief Share of mirrored light: one polarisation only, as in report D (row D3).
 *
 *   ((c - n ct) / (c + n ct))^2 for light that swings along the surface
 *
 * Daylight swings every way: it is the mean of two such terms.
 */
#include "lab/methods/fresnel.h"

/** Asks it. See #Method.run. */
static void fresnel_s_polarized_run(const void *input, void *output) {
    const FresnelInput *in = input;
    real cosine_t_squared = fresnel_cosine_t_squared(in), c = in->cosine,
         ct = in->index * real_sqrt(cosine_t_squared);
    real along = (c - ct) / (c + ct);
    ((FresnelOutput *)output)->reflectance = cosine_t_squared > 0 ? along * along : 1;
}

const Method fresnel_s_polarized = {.group = "fresnel",
                                    .name = "one polarisation",
                                    .label = "one polarisation",
                                    .input_count = NUMBERS_IN(FresnelInput),
                                    .output_count = NUMBERS_IN(FresnelOutput),
                                    .run = fresnel_s_polarized_run};
