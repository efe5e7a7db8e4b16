/**
 * @file
 * @brief Sphere by projection: report C's way (row C1), as a point of the world.
 *
 *   l = (C - P0).d,  H = P0 + l d,  h^2 = R^2 - |H - C|^2,  t = l -+ h
 *
 * H is the point of the line nearest to the centre. It is rounded as coordinates are: far from the
 * origin of the world H - C is mostly that rounding.
 */
#include "lab/methods/sphere.h"

/** Asks it. See #Method.run. */
static void sphere_projection_run(const void *input, void *output) {
    const SphereInput *in = input;
    Vec3 d = in->direction;
    real l = vec3_dot(vec3_subtract(in->center, in->origin), d);
    Vec3 nearest = vec3_add(in->origin, vec3_scale(d, l));
    Vec3 v = vec3_subtract(nearest, in->center);
    real h_squared = in->radius * in->radius - vec3_dot(v, v);
    real h = real_sqrt(h_squared);
    ((SphereOutput *)output)->distance =
        h_squared >= 0 ? sphere_nearest_root(l - h, l + h) : INFINITE;
}

const Method sphere_projection = {.group = "sphere",
                                  .name = "projection",
                                  .label = "projection",
                                  .input_count = NUMBERS_IN(SphereInput),
                                  .output_count = NUMBERS_IN(SphereOutput),
                                  .run = sphere_projection_run};
