/**
 * @file
 * @brief Between mirroring balls: what is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_BOUNCES_H
#define DIOPTRE_LAB_METHODS_BOUNCES_H

#include "lab/methods/method.h"
#include "trace/vector.h"

/** A ray between four balls. */
typedef struct BouncesQuestion {
    Vector origin;     /**< Where it starts. */
    Vector direction;  /**< Which way, of length 1 but for rounding. */
    Vector centers[4]; /**< The balls' centres. */
    real radius;       /**< Their radius. */
    real count;        /**< How often it is mirrored. */
} BouncesQuestion;

/** Where it goes then. */
typedef struct BouncesAnswer {
    Vector direction; /**< NaN where it leaves the balls before. */
} BouncesAnswer;

/** A ray that is mirrored. */
typedef struct Bouncing {
    Vector origin;    /**< Where it starts. */
    Vector direction; /**< Which way. */
    int ball;         /**< The ball that it comes from; -1: none. */
} Bouncing;

/** Mirrors a ray at the ball that it meets first, and moves it there.
 *  @param q The question. @param[in,out] ray The ray; its direction NaN where it meets none. */
void bounce(const BouncesQuestion *q, Bouncing *ray);

#endif
