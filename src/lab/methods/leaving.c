/**
 * @file
 * @brief What all ways of leaving a surface have in common: the sphere, the mirror, the glass.
 */
#include "lab/methods/leaving.h"

/** The roots of a ray and a sphere. */
typedef struct Roots {
    real near; /**< The smaller; NaN: there is none. */
    real far;  /**< The larger. */
} Roots;

/** @return Both roots, by projection relative to the origin. @param q The sphere. @param origin
 *  Where the ray starts. @param direction Which way. */
static Roots roots_of(const LeavingQuestion *q, Vector origin, Vector direction) {
    Vector f = vector_subtract(q->center, origin);
    real l = vector_dot(f, direction);
    Vector v = vector_subtract(vector_scale(direction, l), f);
    real h = real_sqrt(q->radius * q->radius - vector_dot(v, v));
    return (Roots){l - h, l + h};
}

/** @return A refracted direction (Snell, as in GLSL). @param d The direction. @param n The normal,
 *  against it. @param ratio The indices'. */
static Vector refracted(Vector d, Vector n, real ratio) {
    real cosine = -vector_dot(d, n);
    real k = 1 - ratio * ratio * (1 - cosine * cosine);
    return vector_add(vector_scale(d, ratio), vector_scale(n, ratio * cosine - real_sqrt(k)));
}

Leaving leaving_of(const LeavingQuestion *q) {
    Vector d = q->direction;
    real t = roots_of(q, q->origin, d).near;
    Vector point = vector_add(q->origin, vector_scale(d, t));
    Vector normal = vector_normalize(vector_subtract(point, q->center));
    Vector mirrored = vector_add(d, vector_scale(normal, -2 * vector_dot(d, normal)));
    Vector onward = q->ratio > 0 ? refracted(d, normal, q->ratio) : mirrored;
    return (Leaving){point, normal, vector_normalize(onward)};
}

LeavingAnswer leaving_answer(const LeavingQuestion *q, const Leaving *leaving,
                             const Second *second) {
    Roots roots = roots_of(q, second->origin, leaving->direction);
    Vector moved = vector_subtract(second->origin, leaving->point);
    return (LeavingAnswer){.distance = roots.near > second->least  ? roots.near
                                       : roots.far > second->least ? roots.far
                                                                   : INFINITE,
                           .shift = real_sqrt(vector_dot(moved, moved)) + second->least};
}
