/**
 * @file
 * @brief A ray is mirrored at the first of four balls.
 */
#include "lab/methods/bounces.h"

/** @return How far a ball is; #INFINITE: it is not met. */
static real bounces_sphere_distance(const BouncesInput *in, const BounceRay *ray, int sphere) {
    Vec3 f = vec3_subtract(in->centers[sphere], ray->origin);
    real l = vec3_dot(f, ray->direction);
    Vec3 v = vec3_subtract(vec3_scale(ray->direction, l), f);
    real h_squared = in->radius * in->radius - vec3_dot(v, v);
    real t = l - real_sqrt(h_squared);
    return h_squared > 0 && t > 0 && sphere != ray->sphere ? t : INFINITE;
}

void bounces_reflect(const BouncesInput *in, BounceRay *ray) {
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
