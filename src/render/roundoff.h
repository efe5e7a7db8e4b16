/**
 * @file
 * @brief What estimates of float's rounding errors share.
 */
#ifndef DIOPTRE_RENDER_ROUNDOFF_H
#define DIOPTRE_RENDER_ROUNDOFF_H

#include "base/vec3d.h"

/** Half an ulp of 1 in float. */
#define FLOAT_ROUNDOFF 0x1p-24

/** @return The largest coordinate of a point relative to an origin: its rounding is proportional to
 *  that. @param origin That of tracers, see #scene_local_origin. */
static inline double magnitude_from(Vec3d origin, Vec3d point) {
    return vec3d_max_abs(vec3d_subtract(point, origin));
}

#endif
