/**
 * @file
 * @brief Between mirroring balls: what is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_BOUNCES_H
#define DIOPTRE_LAB_METHODS_BOUNCES_H

#include "lab/methods/method.h"
#include "trace/math/vec3.h"

/** A ray between four balls. */
typedef struct BouncesInput {
    Vec3 origin;       /**< Where it starts. */
    Vec3 direction;    /**< Which way, of length 1 but for rounding. */
    Vec3 centers[4];   /**< The balls' centres. */
    real radius;       /**< Their radius. */
    real bounce_count; /**< How often it is mirrored. */
} BouncesInput;

/** Where it goes then. */
typedef struct BouncesOutput {
    Vec3 direction; /**< NaN where it leaves the balls before. */
} BouncesOutput;

/** A ray that is mirrored. */
typedef struct BounceRay {
    Vec3 origin;    /**< Where it starts. */
    Vec3 direction; /**< Which way. */
    int sphere;     /**< The ball that it comes from; -1: none. */
} BounceRay;

/** Mirrors a ray at the ball that it meets first, and moves it there. @param[in,out] ray The ray;
 *  its direction NaN where it meets none. */
void bounces_reflect(const BouncesInput *in, BounceRay *ray);

#endif
