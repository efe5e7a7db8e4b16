/**
 * @file
 * @brief Sphere as in sphere_stable_quadratic.c, computed in the next better precision: what the
 * tracer's own spheres do in float.
 *
 * Float has double. Double, long double and quad have nothing better that is fast: there this is
 * sphere_stable_quadratic.c again.
 */
#include "lab/methods/sphere.h"

/** Asks it. See #Method.run. */
static void sphere_mixed_precision_run(const void *input, void *output) {
    const SphereInput *in = input;
    Vec3w d = vec3_widen(in->direction);
    Vec3w f = vec3w_subtract(vec3_widen(in->origin), vec3_widen(in->center));
    wide a = vec3w_dot(d, d), radius = widen(in->radius);
    wide b = -vec3w_dot(f, d);
    Vec3w l = vec3w_add_scaled(f, d, b / a);
    wide discriminant = radius * radius - vec3w_dot(l, l);
    wide c = vec3w_dot(f, f) - radius * radius;
    wide root = wide_sqrt(a * discriminant);
    wide sum = b > 0 ? b + root : b - root;
    wide near = b > 0 ? c / sum : sum / a;
    wide far = b > 0 ? sum / a : c / sum;
    ((SphereOutput *)output)->distance =
        discriminant >= 0 ? sphere_nearest_root(narrow(near), narrow(far)) : INFINITE;
}

const Method sphere_mixed_precision = {.group = "sphere",
                                       .name = "mixed",
                                       .label = "mixed",
                                       .input_count = NUMBERS_IN(SphereInput),
                                       .output_count = NUMBERS_IN(SphereOutput),
                                       .run = sphere_mixed_precision_run};
