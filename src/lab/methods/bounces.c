/**
 * @file
 * @brief A ray is mirrored at the first of four balls.
 */
#include "lab/methods/bounces.h"

/** @return How far a ball is; #INFINITE: it is not met. @param q The question. @param ray The ray.
 *  @param ball Which. */
static real distance_to(const BouncesQuestion *q, const Bouncing *ray, int ball) {
    Vector f = vector_subtract(q->centers[ball], ray->origin);
    real l = vector_dot(f, ray->direction);
    Vector v = vector_subtract(vector_scale(ray->direction, l), f);
    real h_squared = q->radius * q->radius - vector_dot(v, v);
    real t = l - real_sqrt(h_squared);
    return h_squared > 0 && t > 0 && ball != ray->ball ? t : INFINITE;
}

void bounce(const BouncesQuestion *q, Bouncing *ray) {
    real nearest = INFINITE;
    int ball = -1;
    for (int i = 0; i < 4; i++) {
        real t = distance_to(q, ray, i);
        ball = t < nearest ? i : ball;
        nearest = real_min(t, nearest);
    }
    if (ball < 0) {
        real nan = INFINITE - INFINITE;
        ray->direction = (Vector){nan, nan, nan};
        return;
    }
    Vector d = ray->direction;
    Vector point = vector_add(ray->origin, vector_scale(d, nearest));
    Vector n = vector_normalize(vector_subtract(point, q->centers[ball]));
    *ray = (Bouncing){point, vector_add(d, vector_scale(n, -2 * vector_dot(d, n))), ball};
}
