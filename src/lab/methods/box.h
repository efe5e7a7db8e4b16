/**
 * @file
 * @brief Does a ray meet a box along the axes? What is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_BOX_H
#define DIOPTRE_LAB_METHODS_BOX_H

#include "lab/methods/method.h"
#include "trace/vector.h"

/** A ray and a box. */
typedef struct BoxQuestion {
    Vector origin;    /**< Where the ray starts. */
    Vector direction; /**< Which way. */
    Vector low;       /**< Lowest corner. */
    Vector high;      /**< Highest corner. */
} BoxQuestion;

/** Where it is met. */
typedef struct BoxAnswer {
    real distance; /**< Of the nearest meeting ahead; #INFINITE: there is none. */
    real count;    /**< How often its surface is met ahead: from inside it must be once. */
} BoxAnswer;

/** The interval of a ray between two parallel planes, or in a box. */
typedef struct Slab {
    real near; /**< Where it begins. */
    real far;  /**< Where it ends. */
} Slab;

/** @return What a box answers. @param inside Where the ray is inside. */
static inline BoxAnswer box_answer(Slab inside) {
    int is_met = inside.near <= inside.far && inside.far >= 0;
    return (BoxAnswer){.distance = is_met ? (inside.near > 0 ? inside.near : inside.far) : INFINITE,
                       .count = is_met ? (inside.near > 0 ? 2 : 1) : 0};
}

#endif
