/**
 * @file
 * @brief Plane by a point of it, as in reports C and D (rows C1, D1).
 *
 *   t = (Q - P0).N / d.N
 *
 * Q - P0 is long where the point lies far away, and its product with N cancels.
 */
#include "lab/methods/plane.h"

/** Asks it. See #Method.run. */
static void plane_point_normal_run(const void *input, void *output) {
    const PlaneInput *in = input;
    real height = vec3_dot(vec3_subtract(in->point, in->origin), in->normal);
    ((PlaneOutput *)output)->distance = height / vec3_dot(in->direction, in->normal);
}

const Method plane_point_normal = {.group = "plane",
                                   .name = "by a point",
                                   .label = "by a point",
                                   .input_count = NUMBERS_IN(PlaneInput),
                                   .output_count = NUMBERS_IN(PlaneOutput),
                                   .run = plane_point_normal_run};
