/**
 * @file
 * @brief Where does a ray point after many reflections between four spheres?
 */
#include "lab/methods/family.h"

/** A ray between four spheres. */
typedef struct BouncesInput {
    Vec3 origin;       /**< Origin of the ray. */
    Vec3 direction;    /**< Direction, of length 1 but for rounding. */
    Vec3 centers[4];   /**< Centres of the spheres. */
    real radius;       /**< Their radius. */
    real bounce_count; /**< Number of reflections. */
} BouncesInput;

/** The ray after the last reflection. */
typedef struct BouncesOutput {
    Vec3 direction; /**< NaN: the ray left the spheres before. */
} BouncesOutput;

/** A ray on its way. */
typedef struct BounceRay {
    Vec3 origin;    /**< Origin. */
    Vec3 direction; /**< Direction. */
    int sphere;     /**< Sphere that it was reflected by; -1: none. */
} BounceRay;

/** @return The distance to a sphere; #INFINITE: the ray misses it. */
static real bounces_sphere_distance(const BouncesInput *in, const BounceRay *ray, int sphere) {
    Vec3 f = vec3_subtract(in->centers[sphere], ray->origin);
    real l = vec3_dot(f, ray->direction);
    Vec3 v = vec3_subtract(vec3_scale(ray->direction, l), f);
    real h_squared = in->radius * in->radius - vec3_dot(v, v);
    real t = l - real_sqrt(h_squared);
    return h_squared > 0 && t > 0 && sphere != ray->sphere ? t : INFINITE;
}

/** Reflects a ray at the nearest sphere, d' = d - 2 (d.n) n; its direction is NaN where there is
 *  none. */
static void bounces_reflect(const BouncesInput *in, BounceRay *ray) {
    real nearest = INFINITE;
    int sphere = -1;
    for (int i = 0; i < 4; i++) {
        real t = bounces_sphere_distance(in, ray, i);
        sphere = t < nearest ? i : sphere;
        nearest = real_min(t, nearest);
    }
    if (sphere < 0) {
        real nan = INFINITE - INFINITE;
        ray->direction = (Vec3){nan, nan, nan};
        return;
    }
    Vec3 d = ray->direction;
    Vec3 point = vec3_add(ray->origin, vec3_scale(d, nearest));
    Vec3 n = vec3_normalize(vec3_subtract(point, in->centers[sphere]));
    *ray = (BounceRay){point, vec3_add(d, vec3_scale(n, -2 * vec3_dot(d, n))), sphere};
}

/**
 * Directions as the formula gives them.
 *
 * The length of d drifts by one rounding per reflection. That is little: a curved mirror multiplies
 * the error of an angle by about 2.5.
 */
METHOD(bounces_plain, BouncesInput, BouncesOutput) {
    BounceRay ray = {in->origin, in->direction, -1};
    for (int i = 0; i < (int)in->bounce_count; i++) {
        bounces_reflect(in, &ray);
    }
    return (BouncesOutput){ray.direction};
}

/** Directions normalised after each reflection. */
METHOD(bounces_normalized, BouncesInput, BouncesOutput) {
    BounceRay ray = {in->origin, in->direction, -1};
    for (int i = 0; i < (int)in->bounce_count; i++) {
        bounces_reflect(in, &ray);
        ray.direction = vec3_normalize(ray.direction);
    }
    return (BouncesOutput){ray.direction};
}

const MethodFamily bounces_family = {
    FAMILY("bounces", BouncesInput, BouncesOutput),
    (const Method[]){{"plain", "plain", bounces_plain_run},
                     {"normalized", "normalized", bounces_normalized_run},
                     {0}}};
