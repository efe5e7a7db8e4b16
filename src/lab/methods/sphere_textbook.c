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

/** Asks it. See #Method.run. @param question A #SphereQuestion. @param[out] answer A
 *  #SphereAnswer. */
static void run(const void *question, void *answer) {
    const SphereQuestion *q = question;
    Vector f = vector_subtract(q->origin, q->center), d = q->direction;
    real a = vector_dot(d, d);
    real b = 2 * vector_dot(f, d);
    real c = vector_dot(f, f) - q->radius * q->radius;
    real discriminant = b * b - 4 * a * c;
    real root = real_sqrt(discriminant);
    ((SphereAnswer *)answer)->distance =
        discriminant >= 0 ? nearest_ahead((-b - root) / (2 * a), (-b + root) / (2 * a)) : INFINITE;
}

const Method sphere_textbook = {.family = "sphere",
                                .name = "textbook",
                                .label = "textbook",
                                .inputs = NUMBERS_OF(SphereQuestion),
                                .outputs = NUMBERS_OF(SphereAnswer),
                                .run = run};
