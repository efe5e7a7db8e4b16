/**
 * @file
 * @brief Sphere by projection, relative to the ray's origin.
 *
 *   f = C - P0,  l = f.d,  v = l d - f,  h^2 = R^2 - v.v,  t = l -+ h
 *
 * As sphere_projection.c, but P0 is never added back: |v| is known to half an ulp of the distance,
 * wherever in the world both are.
 */
#include "lab/methods/sphere.h"

/** Asks it. See #Method.run. */
static void sphere_projection_relative_run(const void *input, void *output) {
    const SphereInput *in = input;
    Vec3 d = in->direction, f = vec3_subtract(in->center, in->origin);
    real l = vec3_dot(f, d);
    Vec3 v = vec3_subtract(vec3_scale(d, l), f);
    real h_squared = in->radius * in->radius - vec3_dot(v, v);
    real h = real_sqrt(h_squared);
    ((SphereOutput *)output)->distance =
        h_squared >= 0 ? sphere_nearest_root(l - h, l + h) : INFINITE;
}

const Method sphere_projection_relative = {.group = "sphere",
                                           .name = "relative projection",
                                           .label = "relative",
                                           .input_count = NUMBERS_IN(SphereInput),
                                           .output_count = NUMBERS_IN(SphereOutput),
                                           .run = sphere_projection_relative_run};
