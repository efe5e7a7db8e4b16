/**
 * @file
 * @brief Sphere with a discriminant that does not cancel, and the near root as a quotient (Haines,
 *        Günther, Akenine-Möller, *Precision Improvements for Ray/Sphere Intersection*, Ray Tracing
 *        Gems 7).
 *
 *   f = P0 - C,  a = d.d,  b = -f.d,  l = f + (b / a) d,  D = R^2 - l.l,  c = f.f - R^2
 *   q = b + sign(b) sqrt(a D),  t = c / q and q / a
 *
 * The product of the roots is c / a, so the one that would come by subtraction comes by division.
 * What is left is c itself: near the surface of a large sphere it is a difference of large squares.
 */
#include "lab/methods/sphere.h"

/** Asks it. See #Method.run. */
static void sphere_stable_quadratic_run(const void *input, void *output) {
    const SphereInput *in = input;
    Vec3 d = in->direction, f = vec3_subtract(in->origin, in->center);
    real a = vec3_dot(d, d);
    real b = -vec3_dot(f, d);
    Vec3 l = vec3_add(f, vec3_scale(d, b / a));
    real discriminant = in->radius * in->radius - vec3_dot(l, l);
    real c = vec3_dot(f, f) - in->radius * in->radius;
    real root = real_sqrt(a * discriminant);
    real sum = b > 0 ? b + root : b - root;
    real near = b > 0 ? c / sum : sum / a;
    real far = b > 0 ? sum / a : c / sum;
    ((SphereOutput *)output)->distance =
        discriminant >= 0 ? sphere_nearest_root(near, far) : INFINITE;
}

const Method sphere_stable_quadratic = {.group = "sphere",
                                        .name = "Haines",
                                        .label = "Haines",
                                        .input_count = NUMBERS_IN(SphereInput),
                                        .output_count = NUMBERS_IN(SphereOutput),
                                        .run = sphere_stable_quadratic_run};
