/**
 * @file
 * @brief Sphere by the quadratic of the textbooks, relative to the centre.
 *
 *   f = P0 - C,  a = d.d,  b = 2 f.d,  c = f.f - R^2,  t = (-b -+ sqrt(b^2 - 4 a c)) / 2 a
 *
 * No coordinates are squared any more, but b^2 and 4ac still share their leading digits: the error
 * of t over R grows as k^2 half ulps, k the distance over the radius.
 */
#include "lab/methods/sphere.h"

/** Asks it. See #Method.run. */
static void sphere_textbook_run(const void *input, void *output) {
    const SphereInput *in = input;
    Vec3 f = vec3_subtract(in->origin, in->center), d = in->direction;
    real a = vec3_dot(d, d);
    real b = 2 * vec3_dot(f, d);
    real c = vec3_dot(f, f) - in->radius * in->radius;
    real discriminant = b * b - 4 * a * c;
    real root = real_sqrt(discriminant);
    ((SphereOutput *)output)->distance =
        discriminant >= 0 ? sphere_nearest_root((-b - root) / (2 * a), (-b + root) / (2 * a))
                          : INFINITE;
}

const Method sphere_textbook = {.group = "sphere",
                                .name = "textbook",
                                .label = "textbook",
                                .input_count = NUMBERS_IN(SphereInput),
                                .output_count = NUMBERS_IN(SphereOutput),
                                .run = sphere_textbook_run};
