/**
 * @file
 * @brief How far from its pole is a point of a sphere? What is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_LATITUDE_H
#define DIOPTRE_LAB_METHODS_LATITUDE_H

#include "lab/methods/method.h"
#include "trace/vector.h"

/** A point of a sphere. */
typedef struct LatitudeQuestion {
    Vector point;  /**< The point, rounded as a hit is. */
    Vector center; /**< The sphere's centre. */
    real radius;   /**< Its radius. */
} LatitudeQuestion;

/** Its place on a map. */
typedef struct LatitudeAnswer {
    real angle; /**< From the upper pole, radians. */
} LatitudeAnswer;

#endif
