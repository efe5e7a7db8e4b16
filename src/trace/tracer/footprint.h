/**
 * @file
 * @brief Pixel footprints: the size of the smallest visible detail at a distance.
 */
#ifndef DIOPTRE_TRACE_TRACER_FOOTPRINT_H
#define DIOPTRE_TRACE_TRACER_FOOTPRINT_H

#include "trace/tracer/camera.h"

/** The footprint of a pixel: a cone from the camera. */
typedef struct Footprint {
    scalar pixel_fraction; /**< The fraction of half a pixel below which details are invisible. */
    Vec3s camera_position; /**< The apex of the cone. */
    scalar spread;         /**< The smallest visible size at distance 1. */
} Footprint;

/** Sets the camera. */
static inline void footprint_set_camera(Footprint *footprint, const Camera *camera) {
    footprint->camera_position =
        (Vec3s){real_lane(camera->origin.x, 0), real_lane(camera->origin.y, 0),
                real_lane(camera->origin.z, 0)};
    footprint->spread =
        footprint->pixel_fraction * real_lane(real_sqrt(vec3_dot(camera->up, camera->up)), 0);
}

#endif
