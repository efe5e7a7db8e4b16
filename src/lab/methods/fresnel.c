/**
 * @file
 * @brief Which fraction of the light does a dielectric surface reflect?
 *
 * In the formulas c is the cosine of the angle of incidence, n the relative index of refraction, ct
 * the cosine of the angle of refraction.
 */
#include "trace/materials/fresnel.h"
#include "lab/methods/family.h"

/** Light at a surface. */
typedef struct FresnelInput {
    real cosine; /**< Of the angle of incidence, 0 to 1: c. */
    real index;  /**< Index beyond the surface over the index on the ray's side: n. */
} FresnelInput;

/** The reflectance. */
typedef struct FresnelOutput {
    real reflectance; /**< 0 to 1. */
} FresnelOutput;

/** @return ct^2; negative: total internal reflection. */
static real fresnel_cosine_t_squared(const FresnelInput *in) {
    return 1 - (1 - in->cosine) * (1 + in->cosine) / (in->index * in->index);
}

/** @return A reflectance, 1 in total internal reflection. @param cosine_t_squared ct^2. */
static FresnelOutput fresnel_output(real cosine_t_squared, real reflectance) {
    return (FresnelOutput){cosine_t_squared > 0 ? reflectance : 1};
}

/**
 * One polarisation only, as in report D (doc/reports.md).
 *
 *   ((c - n ct) / (c + n ct))^2 for light polarised along the surface
 *
 * Unpolarised light is the mean of two such terms.
 */
METHOD(fresnel_s_polarized, FresnelInput, FresnelOutput) {
    real cosine_t_squared = fresnel_cosine_t_squared(in), c = in->cosine,
         ct = in->index * real_sqrt(cosine_t_squared);
    real r_s = (c - ct) / (c + ct);
    return fresnel_output(cosine_t_squared, r_s * r_s);
}

/** @return Schlick's polynomial. @param c The cosine. */
static real fresnel_schlick_of(const FresnelInput *in, real c) {
    real root = (in->index - 1) / (in->index + 1);
    real m = 1 - c, r0 = root * root;
    return r0 + (1 - r0) * m * m * m * m * m;
}

/**
 * Schlick's approximation (*An Inexpensive BRDF Model for Physically-based Rendering*, Computer
 * Graphics Forum 1994).
 *
 *   R0 + (1 - R0) (1 - c)^5,  R0 = ((n - 1) / (n + 1))^2,  the cosine on the side of the lower
 * index
 */
METHOD(fresnel_schlick, FresnelInput, FresnelOutput) {
    real cosine_t_squared = fresnel_cosine_t_squared(in);
    real c = in->index < 1 ? real_sqrt(cosine_t_squared) : in->cosine;
    return fresnel_output(cosine_t_squared, fresnel_schlick_of(in, c));
}

/**
 * Schlick's approximation with the cosine of incidence on both sides.
 *
 * Inside glass it stays low up to the critical angle, and then jumps to 1.
 */
METHOD(fresnel_schlick_wrong_cosine, FresnelInput, FresnelOutput) {
    return fresnel_output(fresnel_cosine_t_squared(in), fresnel_schlick_of(in, in->cosine));
}

/**
 * Both polarisations (Fresnel, 1823), as the tracer computes them.
 *
 *   the mean of ((c - n ct) / (c + n ct))^2 and ((n c - ct) / (n c + ct))^2
 */
METHOD(fresnel_exact, FresnelInput, FresnelOutput) {
    real cosine_t_squared = fresnel_cosine_t_squared(in), c = in->cosine, n = in->index,
         ct = real_sqrt(cosine_t_squared);
    real r_s = (c - n * ct) / (c + n * ct), r_p = (n * c - ct) / (n * c + ct);
    return fresnel_output(cosine_t_squared, (r_s * r_s + r_p * r_p) / 2);
}

/**
 * Both polarisations, by the smaller of reflectance and transmittance.
 *
 *   R as in #fresnel_exact,  T = the mean of 4 c n ct / (c + n ct)^2 and 4 c n ct / (n c + ct)^2
 *
 * R + T = 1. Near grazing incidence R is near 1 and has seven roundings of a number near 1. T has
 * as many of a small number, and 1 - T has one rounding more.
 */
METHOD(fresnel_smaller_fraction, FresnelInput, FresnelOutput) {
    real cosine_t_squared = fresnel_cosine_t_squared(in), c = in->cosine, n = in->index,
         ct = real_sqrt(cosine_t_squared);
    real sum_s = c + n * ct, sum_p = n * c + ct;
    real r_s = (c - n * ct) / sum_s, r_p = (n * c - ct) / sum_p;
    real reflectance = (r_s * r_s + r_p * r_p) / 2;
    real transmittance = 2 * c * n * ct * (1 / (sum_s * sum_s) + 1 / (sum_p * sum_p));
    return fresnel_output(cosine_t_squared,
                          reflectance < transmittance ? reflectance : 1 - transmittance);
}

/**
 * The tracer's own function, #refraction_at, in one lane: it computes the refracted direction, too.
 */
METHOD(fresnel_dioptre, FresnelInput, FresnelOutput) {
    // The normal is y, so that the cosine of incidence is the input to the bit.
    real sine = real_sqrt((1 - in->cosine) * (1 + in->cosine));
    Vec3 incident = {sine, -in->cosine, 0}, normal = {0, 1, 0};
    return (FresnelOutput){refraction_at(incident, normal, 1, in->index, 0).reflectance};
}

const MethodFamily fresnel_family = {
    FAMILY("fresnel", FresnelInput, FresnelOutput),
    (const Method[]){
        {"one polarisation", "one polarisation", fresnel_s_polarized_run},
        {"Schlick", "Schlick", fresnel_schlick_run},
        {"Schlick by the inner cosine", "inner cosine", fresnel_schlick_wrong_cosine_run},
        {"exact", "exact", fresnel_exact_run},
        {"exact by both shares", "both shares", fresnel_smaller_fraction_run},
        {"dioptre", "dioptre", fresnel_dioptre_run},
        {0}}};
