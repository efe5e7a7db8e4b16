/**
 * @file
 * @brief Share of mirrored light: both polarisations (Fresnel, 1823). The tracer's way.
 *
 *   ((c - n ct) / (c + n ct))^2 and ((n c - ct) / (n c + ct))^2, their mean
 */
#include "lab/methods/fresnel.h"

/** Asks it. See #Method.run. */
static void fresnel_exact_run(const void *input, void *output) {
    const FresnelInput *in = input;
    real cosine_t_squared = fresnel_cosine_t_squared(in), c = in->cosine, n = in->index,
         ct = real_sqrt(cosine_t_squared);
    real along = (c - n * ct) / (c + n * ct), across = (n * c - ct) / (n * c + ct);
    ((FresnelOutput *)output)->reflectance =
        cosine_t_squared > 0 ? (along * along + across * across) / 2 : 1;
}

const Method fresnel_exact = {.group = "fresnel",
                              .name = "exact",
                              .label = "exact",
                              .input_count = NUMBERS_IN(FresnelInput),
                              .output_count = NUMBERS_IN(FresnelOutput),
                              .run = fresnel_exact_run};
