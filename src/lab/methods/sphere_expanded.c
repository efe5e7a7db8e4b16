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

/** Asks it. See #Method.run. @param question A #SphereQuestion. @param[out] answer A
 *  #SphereAnswer. */
static void run(const void *question, void *answer) {
    const SphereQuestion *q = question;
    Vector p = q->origin, d = q->direction, center = q->center;
    real a = vector_dot(d, d);
    real b = 2 * (vector_dot(d, p) - vector_dot(d, center));
    real c = vector_dot(p, p) + vector_dot(center, center) - 2 * vector_dot(p, center) -
             q->radius * q->radius;
    real discriminant = b * b - 4 * a * c;
    real root = real_sqrt(discriminant);
    ((SphereAnswer *)answer)->distance =
        discriminant >= 0 ? nearest_ahead((-b - root) / (2 * a), (-b + root) / (2 * a)) : INFINITE;
}

const Method sphere_expanded = {.family = "sphere",
                                .name = "expanded",
                                .label = "expanded",
                                .inputs = NUMBERS_OF(SphereQuestion),
                                .outputs = NUMBERS_OF(SphereAnswer),
                                .run = run};
