/**
 * @file
 * @brief The normal of a distance field: what is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_GRADIENT_H
#define DIOPTRE_LAB_METHODS_GRADIENT_H

#include "lab/methods/method.h"
#include "trace/vector.h"

/** A point of the surface of a ball. */
typedef struct GradientQuestion {
    Vector point;  /**< The point. */
    Vector center; /**< The ball's centre. */
    real radius;   /**< Its radius. */
    real step;     /**< How far around the point the field is asked: h. */
} GradientQuestion;

/** A normal, of length 1 but for rounding. */
typedef struct GradientAnswer {
    Vector normal; /**< It. */
} GradientAnswer;

/** @return How far a point is from the ball. @param q The question. @param dx How far beside its
 *  point, along x. @param dy Along y. @param dz Along z. */
static inline real field_at(const GradientQuestion *q, real dx, real dy, real dz) {
    Vector beside = vector_add(q->point, (Vector){dx, dy, dz});
    Vector arm = vector_subtract(beside, q->center);
    return real_sqrt(vector_dot(arm, arm)) - q->radius;
}

#endif
