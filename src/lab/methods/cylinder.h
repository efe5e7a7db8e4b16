/**
 * @file
 * @brief Where does a ray first meet a cylinder that stands upright? What is asked, and answered.
 */
#ifndef DIOPTRE_LAB_METHODS_CYLINDER_H
#define DIOPTRE_LAB_METHODS_CYLINDER_H

#include "lab/methods/method.h"
#include "trace/math/vec3.h"

/** A ray and a cylinder. */
typedef struct CylinderInput {
    Vec3 origin;    /**< Where the ray starts. */
    Vec3 direction; /**< Which way. */
    Vec3 base;      /**< The centre of the cylinder's base; its axis goes up from there. */
    real radius;    /**< Its radius. */
    real height;    /**< Its height; the wall alone has none. */
} CylinderInput;

/** Where it is met. */
typedef struct CylinderOutput {
    real distance; /**< Of the nearest meeting ahead; #INFINITE: there is none. */
    real count;    /**< How often a solid is met ahead: from inside it must be once. */
} CylinderOutput;

#endif
