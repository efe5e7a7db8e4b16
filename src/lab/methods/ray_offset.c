/**
 * @file
 * @brief Where does a secondary ray start?
 *
 * A ray hits a sphere, and a second ray leaves from the hit point P, reflected or refracted. It
 * must not hit the same surface again at P, must hit whatever comes next, and should start near P.
 * N is the outward normal, d the second ray's direction, u half an ulp of 1.
 */
#include "lab/methods/family.h"

/** A ray and a sphere. */
typedef struct RayOffsetInput {
    Vec3 origin;    /**< Origin of the first ray. */
    Vec3 direction; /**< Direction, of length 1 but for rounding. */
    Vec3 center;    /**< Centre of the sphere. */
    real radius;    /**< Radius of the sphere. */
    real ratio;     /**< Refracted: index outside over index inside; 0: reflected. */
} RayOffsetInput;

/** The second ray. */
typedef struct RayOffsetOutput {
    real distance; /**< Where it hits the sphere again; #INFINITE: nowhere. */
    real shift;    /**< Distance from P to its origin. */
} RayOffsetOutput;

/** Where the first ray hits the sphere, and the direction from there. */
typedef struct RayOffsetHit {
    Vec3 point;    /**< P. */
    Vec3 normal;   /**< N. */
    Vec3 outgoing; /**< d. */
} RayOffsetHit;

/** Both roots of a ray and a sphere. */
typedef struct RayOffsetRoots {
    real near; /**< The smaller; NaN: the ray misses. */
    real far;  /**< The larger. */
} RayOffsetRoots;

/** @return Both roots, by projection relative to the ray's origin. */
static RayOffsetRoots ray_offset_sphere_roots(const RayOffsetInput *in, Vec3 origin,
                                              Vec3 direction) {
    Vec3 f = vec3_subtract(in->center, origin);
    real l = vec3_dot(f, direction);
    Vec3 v = vec3_subtract(vec3_scale(direction, l), f);
    real h = real_sqrt(in->radius * in->radius - vec3_dot(v, v));
    return (RayOffsetRoots){l - h, l + h};
}

/** @return A refracted direction (Snell's law, as in GLSL). */
static Vec3 ray_offset_refract(Vec3 d, Vec3 n, real ratio) {
    real cosine = -vec3_dot(d, n);
    real k = 1 - ratio * ratio * (1 - cosine * cosine);
    return vec3_add(vec3_scale(d, ratio), vec3_scale(n, ratio * cosine - real_sqrt(k)));
}

/** @return The first ray's hit. */
static RayOffsetHit ray_offset_hit(const RayOffsetInput *in) {
    Vec3 d = in->direction;
    real t = ray_offset_sphere_roots(in, in->origin, d).near;
    Vec3 point = vec3_add(in->origin, vec3_scale(d, t));
    Vec3 normal = vec3_normalize(vec3_subtract(point, in->center));
    Vec3 reflected = vec3_add(d, vec3_scale(normal, -2 * vec3_dot(d, normal)));
    Vec3 outgoing = in->ratio > 0 ? ray_offset_refract(d, normal, in->ratio) : reflected;
    return (RayOffsetHit){point, normal, vec3_normalize(outgoing)};
}

/** @return The second ray. @param t_min Hits nearer than this are ignored. */
static RayOffsetOutput ray_offset_output_of(const RayOffsetInput *in, const RayOffsetHit *hit,
                                            Vec3 origin, real t_min) {
    RayOffsetRoots roots = ray_offset_sphere_roots(in, origin, hit->outgoing);
    Vec3 moved = vec3_subtract(origin, hit->point);
    return (RayOffsetOutput){.distance = roots.near > t_min  ? roots.near
                                         : roots.far > t_min ? roots.far
                                                             : INFINITE,
                             .shift = real_sqrt(vec3_dot(moved, moved)) + t_min};
}

/** @return The second ray, its origin moved along the normal by a signed length. */
static RayOffsetOutput ray_offset_along_normal(const RayOffsetInput *in, const RayOffsetHit *hit,
                                               real offset) {
    return ray_offset_output_of(in, hit, vec3_add(hit->point, vec3_scale(hit->normal, offset)), 0);
}

/** @return A length, signed as d.N is: towards the side that the second ray goes to. */
static real ray_offset_towards(const RayOffsetHit *hit, real length) {
    return vec3_dot(hit->outgoing, hit->normal) > 0 ? length : -length;
}

/**
 * No offset, as in report C (doc/reports.md), figures 2 and 4.
 *
 * P is rounded: it lies inside the sphere as often as outside.
 */
METHOD(ray_offset_none, RayOffsetInput, RayOffsetOutput) {
    RayOffsetHit hit = ray_offset_hit(in);
    return ray_offset_output_of(in, &hit, hit.point, 0);
}

/**
 * Hits nearer than a constant are ignored: t > 1e-4.
 *
 * One constant for all scales is too short where coordinates are large, and too long where things
 * are small.
 */
METHOD(ray_offset_tmin, RayOffsetInput, RayOffsetOutput) {
    RayOffsetHit hit = ray_offset_hit(in);
    return ray_offset_output_of(in, &hit, hit.point, (scalar)1e-4f);
}

/**
 * A constant along the normal, to the side that the second ray goes to.
 *
 *   P + sign(d.N) 1e-4 N
 */
METHOD(ray_offset_normal, RayOffsetInput, RayOffsetOutput) {
    RayOffsetHit hit = ray_offset_hit(in);
    return ray_offset_along_normal(in, &hit, ray_offset_towards(&hit, (scalar)1e-4f));
}

/**
 * A constant along the outward normal: report C's rule for shadow rays, applied to all rays.
 *
 *   P + 1e-4 N
 *
 * Right for shadows and reflections. A ray that enters glass starts before the surface that the
 * first ray has just hit, and hits it again: the transparent sphere that report A could not draw.
 */
METHOD(ray_offset_outward, RayOffsetInput, RayOffsetOutput) {
    RayOffsetHit hit = ray_offset_hit(in);
    return ray_offset_along_normal(in, &hit, (scalar)1e-4f);
}

/** @return A coordinate, moved by 256 of its ulps times the normal's component. */
static real ray_offset_by_ulps(real coordinate, real normal) {
    const real ulps = 256 * 2 * ROUNDOFF, near_zero = (scalar)0.03125f;
    return real_abs(coordinate) < near_zero ? coordinate + normal / 65536
                                            : coordinate + real_abs(coordinate) * ulps * normal;
}

/**
 * Each coordinate moved by a multiple of its ulp (Wächter, Binder, *A Fast and Robust Method for
 * Avoiding Self-Intersection*, Ray Tracing Gems 6).
 *
 *   256 ulps times the normal's component, but N / 65536 near zero
 *
 * Written for all number types, without the original's integer arithmetic on the bits of a float.
 * Near zero the shift is a constant again, and larger than a sphere of radius 1e-6.
 */
METHOD(ray_offset_ulps, RayOffsetInput, RayOffsetOutput) {
    RayOffsetHit hit = ray_offset_hit(in);
    Vec3 n = hit.normal, p = hit.point;
    if (vec3_dot(hit.outgoing, n) < 0) {
        n = vec3_scale(n, -1);
    }
    return ray_offset_output_of(in, &hit,
                                (Vec3){ray_offset_by_ulps(p.x, n.x), ray_offset_by_ulps(p.y, n.y),
                                       ray_offset_by_ulps(p.z, n.z)},
                                0);
}

/**
 * A bound of the rounding error, along the normal.
 *
 *   P + sign(d.N) 32 u (|P| + R) N
 *
 * As long as the coordinates require, and no longer. The tracer's own bounds are similar.
 */
METHOD(ray_offset_error_bound, RayOffsetInput, RayOffsetOutput) {
    RayOffsetHit hit = ray_offset_hit(in);
    real offset = 32 * ROUNDOFF * (vec3_max_abs(hit.point) + in->radius);
    return ray_offset_along_normal(in, &hit, ray_offset_towards(&hit, offset));
}

const MethodFamily ray_offset_family = {
    FAMILY("leaving", RayOffsetInput, RayOffsetOutput),
    (const Method[]){{"no offset", "none", ray_offset_none_run},
                     {"t > 1e-4", "t > 1e-4", ray_offset_tmin_run},
                     {"1e-4 N", "1e-4 N", ray_offset_normal_run},
                     {"1e-4 N outwards", "outwards", ray_offset_outward_run},
                     {"256 ulps", "256 ulps", ray_offset_ulps_run},
                     {"32 u (|P| + R) N", "bound", ray_offset_error_bound_run},
                     {0}}};
