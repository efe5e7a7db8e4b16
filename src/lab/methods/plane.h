/**
 * @file
 * @brief Where does a ray meet a plane? What is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_PLANE_H
#define DIOPTRE_LAB_METHODS_PLANE_H

#include "lab/methods/method.h"
#include "trace/math/vec3.h"

/** A ray and a plane. */
typedef struct PlaneInput {
    Vec3 origin;    /**< Where the ray starts: P0. */
    Vec3 direction; /**< Which way: d. */
    Vec3 point;     /**< A point of the plane: Q. */
    Vec3 normal;    /**< Its normal: N. */
    real offset;    /**< N.Q, worked out once and better than the number type could. */
} PlaneInput;

/** How far it is; NaN or infinite where the ray runs along it. */
typedef struct PlaneOutput {
    real distance; /**< In lengths of the direction. */
} PlaneOutput;

#endif
