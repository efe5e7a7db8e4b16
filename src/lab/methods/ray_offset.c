/**
 * @file
 * @brief What all ways of leaving a surface have in common: the sphere, the mirror, the glass.
 */
#include "lab/methods/ray_offset.h"

/** The roots of a ray and a sphere. */
typedef struct RayOffsetRoots {
    real near; /**< The smaller; NaN: there is none. */
    real far;  /**< The larger. */
} RayOffsetRoots;

/**
 * @return Both roots, by projection relative to the origin.
 * @param origin  Where the ray starts.
 */
static RayOffsetRoots ray_offset_sphere_roots(const RayOffsetInput *in, Vec3 origin,
                                              Vec3 direction) {
    Vec3 f = vec3_subtract(in->center, origin);
    real l = vec3_dot(f, direction);
    Vec3 v = vec3_subtract(vec3_scale(direction, l), f);
    real h = real_sqrt(in->radius * in->radius - vec3_dot(v, v));
    return (RayOffsetRoots){l - h, l + h};
}

/** @return A refracted direction (Snell, as in GLSL). */
static Vec3 ray_offset_refract(Vec3 d, Vec3 n, real ratio) {
    real cosine = -vec3_dot(d, n);
    real k = 1 - ratio * ratio * (1 - cosine * cosine);
    return vec3_add(vec3_scale(d, ratio), vec3_scale(n, ratio * cosine - real_sqrt(k)));
}

RayOffsetHit ray_offset_hit(const RayOffsetInput *in) {
    Vec3 d = in->direction;
    real t = ray_offset_sphere_roots(in, in->origin, d).near;
    Vec3 point = vec3_add(in->origin, vec3_scale(d, t));
    Vec3 normal = vec3_normalize(vec3_subtract(point, in->center));
    Vec3 reflected = vec3_add(d, vec3_scale(normal, -2 * vec3_dot(d, normal)));
    Vec3 outgoing = in->ratio > 0 ? ray_offset_refract(d, normal, in->ratio) : reflected;
    return (RayOffsetHit){point, normal, vec3_normalize(outgoing)};
}

RayOffsetOutput ray_offset_output_of(const RayOffsetInput *in, const RayOffsetHit *hit,
                                     const RayOffsetStart *start) {
    RayOffsetRoots roots = ray_offset_sphere_roots(in, start->origin, hit->outgoing);
    Vec3 moved = vec3_subtract(start->origin, hit->point);
    return (RayOffsetOutput){.distance = roots.near > start->t_min  ? roots.near
                                         : roots.far > start->t_min ? roots.far
                                                                    : INFINITE,
                             .shift = real_sqrt(vec3_dot(moved, moved)) + start->t_min};
}
