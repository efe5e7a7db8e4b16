/**
 * @file
 * @brief Sphere by the quadratic with every product written out: report A's formula (row A2).
 *
 *   a t^2 + b t + c = 0,  a = d.d,  b = 2 (d.P0 - d.C),  c = P0.P0 + C.C - 2 P0.C - R^2
 *
 * c is a difference of squares of coordinates: far from the origin of the world nothing is left of
 * it, and b^2 and 4ac share their leading digits where the sphere is far from the eye.
 */
#include "lab/methods/sphere.h"

/** Asks it. See #Method.run. */
static void sphere_expanded_run(const void *input, void *output) {
    const SphereInput *in = input;
    Vec3 p = in->origin, d = in->direction, center = in->center;
    real a = vec3_dot(d, d);
    real b = 2 * (vec3_dot(d, p) - vec3_dot(d, center));
    real c = vec3_dot(p, p) + vec3_dot(center, center) - 2 * vec3_dot(p, center) -
             in->radius * in->radius;
    real discriminant = b * b - 4 * a * c;
    real root = real_sqrt(discriminant);
    ((SphereOutput *)output)->distance =
        discriminant >= 0 ? sphere_nearest_root((-b - root) / (2 * a), (-b + root) / (2 * a))
                          : INFINITE;
}

const Method sphere_expanded = {.group = "sphere",
                                .name = "expanded",
                                .label = "expanded",
                                .input_count = NUMBERS_IN(SphereInput),
                                .output_count = NUMBERS_IN(SphereOutput),
                                .run = sphere_expanded_run};
