/**
 * @file
 * @brief The footprint of pixels: how finely the camera sees what is how far away.
 */
#ifndef DIOPTRE_TRACE_FOOTPRINT_H
#define DIOPTRE_TRACE_FOOTPRINT_H

#include "trace/eye.h"

/** How finely the camera sees. */
typedef struct Footprint {
    scalar share;  /**< Of half a pixel, that is not seen. */
    Point eye;     /**< Where it is. */
    scalar spread; /**< What is smaller than this at distance 1 is not seen. */
} Footprint;

/** Takes the camera anew. @param[in,out] footprint The footprint. @param eye The camera. */
static inline void footprint_look(Footprint *footprint, const Eye *eye) {
    footprint->eye = (Point){real_lane(eye->origin.x, 0), real_lane(eye->origin.y, 0),
                             real_lane(eye->origin.z, 0)};
    footprint->spread = footprint->share * real_lane(real_sqrt(vector_dot(eye->up, eye->up)), 0);
}

#endif
