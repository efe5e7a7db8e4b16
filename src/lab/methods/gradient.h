/**
 * @file
 * @brief The normal of a distance field: what is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_GRADIENT_H
#define DIOPTRE_LAB_METHODS_GRADIENT_H

#include "lab/methods/method.h"
#include "trace/math/vec3.h"

/** A point of the surface of a ball. */
typedef struct GradientInput {
    Vec3 point;  /**< The point. */
    Vec3 center; /**< The ball's centre. */
    real radius; /**< Its radius. */
    real step;   /**< How far around the point the field is asked: h. */
} GradientInput;

/** A normal, of length 1 but for rounding. */
typedef struct GradientOutput {
    Vec3 normal; /**< It. */
} GradientOutput;

/**
 * @return How far a point is from the ball.
 * @param dx  How far beside its point, along x.
 */
static inline real gradient_sphere_sdf(const GradientInput *in, real dx, real dy, real dz) {
    Vec3 position = vec3_add(in->point, (Vec3){dx, dy, dz});
    Vec3 local = vec3_subtract(position, in->center);
    return real_sqrt(vec3_dot(local, local)) - in->radius;
}

#endif
