/**
 * @file
 * @brief How much does a surface of glass mirror? What is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_FRESNEL_H
#define DIOPTRE_LAB_METHODS_FRESNEL_H

#include "lab/methods/method.h"
#include "trace/root.h"

/** Light at a surface. */
typedef struct FresnelQuestion {
    real cosine; /**< Of the angle between the ray that comes and the normal, 0 to 1. */
    real index;  /**< Index beyond the surface over the index on the ray's side. */
} FresnelQuestion;

/** Share of light. */
typedef struct FresnelAnswer {
    real mirrored; /**< 0 to 1. */
} FresnelAnswer;

/** @return The square of the refracted ray's cosine; negative: there is none, all is mirrored.
 *  @param q The question. */
static inline real refracted_squared(const FresnelQuestion *q) {
    return 1 - (1 - q->cosine) * (1 + q->cosine) / (q->index * q->index);
}

#endif
