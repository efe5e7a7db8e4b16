/**
 * @file
 * @brief What a sphere is made of.
 */
#ifndef DIOPTRE_TRACE_SHAPES_SPHERE_H
#define DIOPTRE_TRACE_SHAPES_SPHERE_H

#include "dioptre/vec3d.h"

/** What a scene file says of a sphere. */
typedef struct SphereParameters {
    Vec3d center;  /**< Its centre. */
    double radius; /**< Its radius, scene units. */
} SphereParameters;

#endif
