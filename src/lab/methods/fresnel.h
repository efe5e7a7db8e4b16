/**
 * @file
 * @brief How much does a surface of glass mirror? What is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_FRESNEL_H
#define DIOPTRE_LAB_METHODS_FRESNEL_H

#include "lab/methods/method.h"
#include "trace/math/real.h"

/** Light at a surface. */
typedef struct FresnelInput {
    real cosine; /**< Of the angle between the ray that comes and the normal, 0 to 1. */
    real index;  /**< Index beyond the surface over the index on the ray's side. */
} FresnelInput;

/** Share of light. */
typedef struct FresnelOutput {
    real reflectance; /**< 0 to 1. */
} FresnelOutput;

/** @return The square of the refracted ray's cosine; negative: there is none, all is mirrored. */
static inline real fresnel_cosine_t_squared(const FresnelInput *in) {
    return 1 - (1 - in->cosine) * (1 + in->cosine) / (in->index * in->index);
}

#endif
