/**
 * @file
 * @brief Marching down to the ground: what is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_SPHERE_TRACING_H
#define DIOPTRE_LAB_METHODS_SPHERE_TRACING_H

#include "lab/methods/method.h"
#include "trace/math/vec3.h"

/** A ray above the plane y = 0, whose distance field is y. */
typedef struct SphereTracingInput {
    Vec3 origin;    /**< Where it starts. */
    Vec3 direction; /**< Which way, of length 1 but for rounding. */
    real tolerance; /**< What is so near is on the surface. */
} SphereTracingInput;

/** Where it stops. */
typedef struct SphereTracingOutput {
    real distance; /**< How far; #INFINITE: out of steps. */
    real steps;    /**< How often the field was asked. */
} SphereTracingOutput;

/** Steps after which a ray is given up. */
enum { SPHERE_TRACING_STEPS = 100000 };

/**
 * @return The field on a ray.
 * @param t  How far along it.
 */
static inline real sphere_tracing_height(const SphereTracingInput *in, real t) {
    return in->origin.y + in->direction.y * t;
}

#endif
