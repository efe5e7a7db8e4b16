/**
 * @file
 * @brief The footprint of pixels: how finely the camera sees what is how far away.
 */
#ifndef DIOPTRE_TRACE_TRACER_FOOTPRINT_H
#define DIOPTRE_TRACE_TRACER_FOOTPRINT_H

#include "trace/tracer/camera.h"

/** How finely the camera sees. */
typedef struct Footprint {
    scalar pixel_fraction; /**< Of half a pixel, that is not seen. */
    Vec3s camera_position; /**< Where it is. */
    scalar spread;         /**< What is smaller than this at distance 1 is not seen. */
} Footprint;

/** Takes the camera anew. */
static inline void footprint_set_camera(Footprint *footprint, const Camera *camera) {
    footprint->camera_position =
        (Vec3s){real_lane(camera->origin.x, 0), real_lane(camera->origin.y, 0),
                real_lane(camera->origin.z, 0)};
    footprint->spread =
        footprint->pixel_fraction * real_lane(real_sqrt(vec3_dot(camera->up, camera->up)), 0);
}

#endif
