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

/** Asks it. See #Method.run. @param question A #SphereQuestion. @param[out] answer A
 *  #SphereAnswer. */
static void run(const void *question, void *answer) {
    const SphereQuestion *q = question;
    Vector d = q->direction, f = vector_subtract(q->center, q->origin);
    real l = vector_dot(f, d);
    Vector v = vector_subtract(vector_scale(d, l), f);
    real h_squared = q->radius * q->radius - vector_dot(v, v);
    real h = real_sqrt(h_squared);
    ((SphereAnswer *)answer)->distance = h_squared >= 0 ? nearest_ahead(l - h, l + h) : INFINITE;
}

const Method sphere_projection_relative = {.family = "sphere",
                                           .name = "relative projection",
                                           .label = "relative",
                                           .inputs = NUMBERS_OF(SphereQuestion),
                                           .outputs = NUMBERS_OF(SphereAnswer),
                                           .run = run};
