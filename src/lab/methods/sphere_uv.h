/**
 * @file
 * @brief How far from its pole is a point of a sphere? What is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_SPHERE_UV_H
#define DIOPTRE_LAB_METHODS_SPHERE_UV_H

#include "lab/methods/method.h"
#include "trace/math/vec3.h"

/** A point of a sphere. */
typedef struct SphereUvInput {
    Vec3 point;  /**< The point, rounded as a hit is. */
    Vec3 center; /**< The sphere's centre. */
    real radius; /**< Its radius. */
} SphereUvInput;

/** Its place on a map. */
typedef struct SphereUvOutput {
    real polar_angle; /**< From the upper pole, radians. */
} SphereUvOutput;

#endif
