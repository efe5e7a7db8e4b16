/**
 * @file
 * @brief Where does a ray start that leaves a surface? What is asked, and answered.
 *
 * A ray meets a sphere; from there a second ray leaves, mirrored or refracted. It must not meet the
 * same place again, must meet what comes after it, and should not start far away.
 */
#ifndef DIOPTRE_LAB_METHODS_LEAVING_H
#define DIOPTRE_LAB_METHODS_LEAVING_H

#include "lab/methods/method.h"
#include "trace/vector.h"

/** A ray and a sphere. */
typedef struct LeavingQuestion {
    Vector origin;    /**< Where the first ray starts. */
    Vector direction; /**< Which way, of length 1 but for rounding. */
    Vector center;    /**< The sphere's centre. */
    real radius;      /**< Its radius. */
    real ratio;       /**< For refraction: index outside over index inside; 0: mirrored. */
} LeavingQuestion;

/** What becomes of the second ray. */
typedef struct LeavingAnswer {
    real distance; /**< Where it meets the sphere again; #INFINITE: nowhere. */
    real shift;    /**< How far from the first point it starts. */
} LeavingAnswer;

/** Where the first ray met the sphere, and what leaves from there. */
typedef struct Leaving {
    Vector point;     /**< The point. */
    Vector normal;    /**< The normal, outwards. */
    Vector direction; /**< Which way the second ray goes. */
} Leaving;

/** A second ray. */
typedef struct Second {
    Vector origin; /**< Where it starts. */
    real least;    /**< What is nearer than this is no meeting. */
} Second;

/** @return What leaves. @param q The question. */
Leaving leaving_of(const LeavingQuestion *q);

/** @return What becomes of the second ray. @param q The question. @param leaving What leaves.
 *  @param second Where it starts. */
LeavingAnswer leaving_answer(const LeavingQuestion *q, const Leaving *leaving,
                             const Second *second);

#endif
