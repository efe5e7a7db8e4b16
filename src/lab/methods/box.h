/**
 * @file
 * @brief Does a ray meet a box along the axes? What is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_BOX_H
#define DIOPTRE_LAB_METHODS_BOX_H

#include "lab/methods/method.h"
#include "trace/math/vec3.h"

/** A ray and a box. */
typedef struct BoxInput {
    Vec3 origin;    /**< Where the ray starts. */
    Vec3 direction; /**< Which way. */
    Vec3 low;       /**< Lowest corner. */
    Vec3 high;      /**< Highest corner. */
} BoxInput;

/** Where it is met. */
typedef struct BoxOutput {
    real distance; /**< Of the nearest meeting ahead; #INFINITE: there is none. */
    real count;    /**< How often its surface is met ahead: from inside it must be once. */
} BoxOutput;

/** The interval of a ray between two parallel planes, or in a box. */
typedef struct SlabInterval {
    real near; /**< Where it begins. */
    real far;  /**< Where it ends. */
} SlabInterval;

/** @return What a box answers. @param interval Where the ray is inside. */
static inline BoxOutput box_output_of(SlabInterval interval) {
    int is_met = interval.near <= interval.far && interval.far >= 0;
    return (BoxOutput){.distance =
                           is_met ? (interval.near > 0 ? interval.near : interval.far) : INFINITE,
                       .count = is_met ? (interval.near > 0 ? 2 : 1) : 0};
}

#endif
