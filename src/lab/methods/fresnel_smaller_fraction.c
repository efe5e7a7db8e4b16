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

/** Answers a question. See #Method.run. */
static void fresnel_smaller_fraction_run(const void *input, void *output) {
    const FresnelInput *in = input;
    real cosine_t_squared = fresnel_cosine_t_squared(in), c = in->cosine, n = in->index,
         ct = real_sqrt(cosine_t_squared);
    real along = c + n * ct, across = n * c + ct;
    real r_s = (c - n * ct) / along, r_p = (n * c - ct) / across;
    real reflectance = (r_s * r_s + r_p * r_p) / 2;
    real transmittance = 2 * c * n * ct * (1 / (along * along) + 1 / (across * across));
    real fraction = reflectance < transmittance ? reflectance : 1 - transmittance;
    ((FresnelOutput *)output)->reflectance = cosine_t_squared > 0 ? fraction : 1;
}

const Method fresnel_smaller_fraction = {.group = "fresnel",
                                         .name = "exact by both shares",
                                         .label = "both shares",
                                         .input_count = NUMBERS_IN(FresnelInput),
                                         .output_count = NUMBERS_IN(FresnelOutput),
                                         .run = fresnel_smaller_fraction_run};
