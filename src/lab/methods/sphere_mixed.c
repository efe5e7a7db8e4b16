/**
 * @file
 * @brief Sphere as in sphere_haines.c, computed in the next better precision: what the tracer's own
 *        spheres do in float.
 *
 * Float has double. Double, long double and quad have nothing better that is fast: there this is
 * sphere_haines.c again.
 */
#include "lab/methods/sphere.h"

/** Asks it. See #Method.run. @param question A #SphereQuestion. @param[out] answer A
 *  #SphereAnswer. */
static void run(const void *question, void *answer) {
    const SphereQuestion *q = question;
    WideVector d = vector_widen(q->direction);
    WideVector f = wide_subtract(vector_widen(q->origin), vector_widen(q->center));
    wide a = wide_dot(d, d), radius = widen(q->radius);
    wide b = -wide_dot(f, d);
    WideVector l = wide_add_scaled(f, d, b / a);
    wide discriminant = radius * radius - wide_dot(l, l);
    wide c = wide_dot(f, f) - radius * radius;
    wide root = wide_sqrt(a * discriminant);
    wide sum = b > 0 ? b + root : b - root;
    wide near = b > 0 ? c / sum : sum / a;
    wide far = b > 0 ? sum / a : c / sum;
    ((SphereAnswer *)answer)->distance =
        discriminant >= 0 ? nearest_ahead(narrow(near), narrow(far)) : INFINITE;
}

const Method sphere_mixed = {.family = "sphere",
                             .name = "mixed",
                             .label = "mixed",
                             .inputs = NUMBERS_OF(SphereQuestion),
                             .outputs = NUMBERS_OF(SphereAnswer),
                             .run = run};
