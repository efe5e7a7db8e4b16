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

/** Asks it. See #Method.run. @param question A #SphereQuestion. @param[out] answer A
 *  #SphereAnswer. */
static void run(const void *question, void *answer) {
    const SphereQuestion *q = question;
    Vector d = q->direction, f = vector_subtract(q->origin, q->center);
    real a = vector_dot(d, d);
    real b = -vector_dot(f, d);
    Vector l = vector_add(f, vector_scale(d, b / a));
    real discriminant = q->radius * q->radius - vector_dot(l, l);
    real c = vector_dot(f, f) - q->radius * q->radius;
    real root = real_sqrt(a * discriminant);
    real sum = b > 0 ? b + root : b - root;
    real near = b > 0 ? c / sum : sum / a;
    real far = b > 0 ? sum / a : c / sum;
    ((SphereAnswer *)answer)->distance = discriminant >= 0 ? nearest_ahead(near, far) : INFINITE;
}

const Method sphere_haines = {.family = "sphere",
                              .name = "Haines",
                              .label = "Haines",
                              .inputs = NUMBERS_OF(SphereQuestion),
                              .outputs = NUMBERS_OF(SphereAnswer),
                              .run = run};
