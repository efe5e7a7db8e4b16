/**
 * @file
 * @brief Sphere as in sphere_haines.c, with c = |P0 - C|^2 - R^2 to twice the precision of the
 *        number type and nothing better needed for it.
 *
 *   x y = p + e exactly, with p = fl(x y) and e = fma(x, y, -p)
 *   x - y = s + e exactly, with s = fl(x - y) and e what #difference gets back of what s lost
 *
 * The products and differences are added up as pairs (Dekker, *A Floating-Point Technique for
 * Extending the Available Precision*, 1971).
 */
#include "lab/methods/functions.h"
#include "lab/methods/sphere.h"

/** A number as the sum of two: it, and what its rounding lost. */
typedef struct Pair2 {
    real high; /**< The number, rounded. */
    real low;  /**< What is left of it. */
} Pair2;

/** @return x - y. @param x A number. @param y Another. */
static Pair2 difference(real x, real y) {
    real s = x - y;
    real back = s - x;
    return (Pair2){s, (x - (s - back)) - (y + back)};
}

/** @return x + y. @param x A pair. @param y Another. */
static Pair2 sum(Pair2 x, Pair2 y) {
    Pair2 s = difference(x.high, -y.high);
    return (Pair2){s.high, s.low + x.low + y.low};
}

/** @return The square of a pair. @param x It. */
static Pair2 square(Pair2 x) {
    real p = x.high * x.high;
    return (Pair2){p, real_fma(x.high, x.high, -p) + 2 * x.high * x.low};
}

/** @return |P0 - C|^2 - R^2. @param q The question. */
static real power_of(const SphereQuestion *q) {
    Pair2 radius_squared = square((Pair2){q->radius, 0});
    Pair2 c = {-radius_squared.high, -radius_squared.low};
    c = sum(c, square(difference(q->origin.x, q->center.x)));
    c = sum(c, square(difference(q->origin.y, q->center.y)));
    c = sum(c, square(difference(q->origin.z, q->center.z)));
    return c.high + c.low;
}

/** Asks it. See #Method.run. @param question A #SphereQuestion. @param[out] answer A
 *  #SphereAnswer. */
static void run(const void *question, void *answer) {
    const SphereQuestion *q = question;
    Vector d = q->direction, f = vector_subtract(q->origin, q->center);
    real a = vector_dot(d, d);
    real b = -vector_dot(f, d);
    // The discriminant has two faces: from the axis where the sphere is far, from c where it is
    // near.
    Vector l = vector_add(f, vector_scale(d, b / a));
    real c = power_of(q);
    real from_axis = q->radius * q->radius - vector_dot(l, l);
    real from_power = b * b / a - c;
    real discriminant = real_abs(b) < q->radius ? from_power : from_axis;
    real root = real_sqrt(a * discriminant);
    real far_sum = b > 0 ? b + root : b - root;
    real near = b > 0 ? c / far_sum : far_sum / a;
    real far = b > 0 ? far_sum / a : c / far_sum;
    ((SphereAnswer *)answer)->distance = discriminant >= 0 ? nearest_ahead(near, far) : INFINITE;
}

const Method sphere_compensated = {.family = "sphere",
                                   .name = "compensated",
                                   .label = "compensated",
                                   .inputs = NUMBERS_OF(SphereQuestion),
                                   .outputs = NUMBERS_OF(SphereAnswer),
                                   .run = run};
