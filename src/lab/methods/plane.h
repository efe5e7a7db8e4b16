/**
 * @file
 * @brief Where does a ray meet a plane? What is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_PLANE_H
#define DIOPTRE_LAB_METHODS_PLANE_H

#include "lab/methods/method.h"
#include "trace/vector.h"

/** A ray and a plane. */
typedef struct PlaneQuestion {
    Vector origin;    /**< Where the ray starts: P0. */
    Vector direction; /**< Which way: d. */
    Vector point;     /**< A point of the plane: Q. */
    Vector normal;    /**< Its normal: N. */
    real offset;      /**< N.Q, worked out once and better than the number type could. */
} PlaneQuestion;

/** How far it is; NaN or infinite where the ray runs along it. */
typedef struct PlaneAnswer {
    real distance; /**< In lengths of the direction. */
} PlaneAnswer;

#endif
