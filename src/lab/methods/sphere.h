/**
 * @file
 * @brief Where does a ray first meet a sphere? What is asked, and what is answered.
 */
#ifndef DIOPTRE_LAB_METHODS_SPHERE_H
#define DIOPTRE_LAB_METHODS_SPHERE_H

#include "lab/methods/method.h"
#include "trace/math/vec3.h"

/** A ray and a sphere. */
typedef struct SphereInput {
    Vec3 origin;    /**< Where the ray starts: P0. */
    Vec3 direction; /**< Which way, of length 1 but for rounding: d. */
    Vec3 center;    /**< The sphere's centre: C. */
    real radius;    /**< Its radius: R. */
} SphereInput;

/** How far it is, or #INFINITE where the ray misses. */
typedef struct SphereOutput {
    real distance; /**< In lengths of the direction. */
} SphereOutput;

/** @return The nearest of two roots that lies ahead, or #INFINITE. */
static inline real sphere_nearest_root(real near, real far) {
    return near > 0 ? near : far > 0 ? far : INFINITE;
}

#endif
