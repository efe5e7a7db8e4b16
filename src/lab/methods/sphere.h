/**
 * @file
 * @brief Where does a ray first meet a sphere? What is asked, and what is answered.
 */
#ifndef DIOPTRE_LAB_METHODS_SPHERE_H
#define DIOPTRE_LAB_METHODS_SPHERE_H

#include "lab/methods/method.h"
#include "trace/vector.h"

/** A ray and a sphere. */
typedef struct SphereQuestion {
    Vector origin;    /**< Where the ray starts: P0. */
    Vector direction; /**< Which way, of length 1 but for rounding: d. */
    Vector center;    /**< The sphere's centre: C. */
    real radius;      /**< Its radius: R. */
} SphereQuestion;

/** How far it is, or #INFINITE where the ray misses. */
typedef struct SphereAnswer {
    real distance; /**< In lengths of the direction. */
} SphereAnswer;

/** @return The nearest of two roots that lies ahead, or #INFINITE. @param near The smaller root.
 *  @param far The larger. */
static inline real nearest_ahead(real near, real far) {
    return near > 0 ? near : far > 0 ? far : INFINITE;
}

#endif
