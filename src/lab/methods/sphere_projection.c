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

/** Asks it. See #Method.run. @param question A #SphereQuestion. @param[out] answer A
 *  #SphereAnswer. */
static void run(const void *question, void *answer) {
    const SphereQuestion *q = question;
    Vector d = q->direction;
    real l = vector_dot(vector_subtract(q->center, q->origin), d);
    Vector nearest = vector_add(q->origin, vector_scale(d, l));
    Vector v = vector_subtract(nearest, q->center);
    real h_squared = q->radius * q->radius - vector_dot(v, v);
    real h = real_sqrt(h_squared);
    ((SphereAnswer *)answer)->distance = h_squared >= 0 ? nearest_ahead(l - h, l + h) : INFINITE;
}

const Method sphere_projection = {.family = "sphere",
                                  .name = "projection",
                                  .label = "projection",
                                  .inputs = NUMBERS_OF(SphereQuestion),
                                  .outputs = NUMBERS_OF(SphereAnswer),
                                  .run = run};
