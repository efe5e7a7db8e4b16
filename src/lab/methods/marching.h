/**
 * @file
 * @brief Marching down to the ground: what is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_MARCHING_H
#define DIOPTRE_LAB_METHODS_MARCHING_H

#include "lab/methods/method.h"
#include "trace/vector.h"

/** A ray above the plane y = 0, whose distance field is y. */
typedef struct MarchingQuestion {
    Vector origin;    /**< Where it starts. */
    Vector direction; /**< Which way, of length 1 but for rounding. */
    real tolerance;   /**< What is so near is on the surface. */
} MarchingQuestion;

/** Where it stops. */
typedef struct MarchingAnswer {
    real distance; /**< How far; #INFINITE: out of steps. */
    real steps;    /**< How often the field was asked. */
} MarchingAnswer;

/** Steps after which a ray is given up. */
enum { MARCHING_STEPS = 100000 };

/** @return The field on a ray. @param q The question. @param t How far along it. */
static inline real height_at(const MarchingQuestion *q, real t) {
    return q->origin.y + q->direction.y * t;
}

#endif
