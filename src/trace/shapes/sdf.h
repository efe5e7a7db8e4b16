/**
 * @file
 * @brief What a scene file says of the surface of a field.
 */
#ifndef DIOPTRE_TRACE_SHAPES_SDF_H
#define DIOPTRE_TRACE_SHAPES_SDF_H

#include "trace/sdf/sdf_program.h"

/** What a scene file says of an `sdf`. */
typedef struct SdfParameters {
    const Sdf *field; /**< Its field; the scene's. */
    double tolerance; /**< How near to the surface is on it. */
    int max_steps;    /**< Steps after which a ray is given up. */
} SdfParameters;

#endif
