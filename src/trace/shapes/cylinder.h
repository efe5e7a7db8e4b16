/**
 * @file
 * @brief What a cylinder is made of.
 */
#ifndef DIOPTRE_TRACE_SHAPES_CYLINDER_H
#define DIOPTRE_TRACE_SHAPES_CYLINDER_H

#include "dioptre/vec3d.h"

#include <stdbool.h>

/** What a scene file says of a cylinder. */
typedef struct CylinderParameters {
    Vec3d base;    /**< Centre of one end. */
    Vec3d top;     /**< Centre of the other. */
    double radius; /**< Its radius, scene units. */
    bool capped;   /**< Whether the ends are closed. */
} CylinderParameters;

#endif
