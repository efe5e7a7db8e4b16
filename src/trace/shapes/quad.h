/**
 * @file
 * @brief What a quad is made of.
 */
#ifndef DIOPTRE_TRACE_SHAPES_QUAD_H
#define DIOPTRE_TRACE_SHAPES_QUAD_H

#include "dioptre/vec3d.h"

/** What a scene file says of a quad. */
typedef struct QuadParameters {
    Vec3d corner; /**< One corner. */
    Vec3d u;      /**< From it to the next. */
    Vec3d v;      /**< From it to the one on the other side. */
} QuadParameters;

#endif
