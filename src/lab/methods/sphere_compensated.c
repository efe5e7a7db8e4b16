/**
 * @file
 * @brief Sphere as in sphere_stable_quadratic.c, with c = |P0 - C|^2 - R^2 to twice the precision
 * of the number type and nothing better needed for it.
 *
 *   x y = p + e exactly, with p = fl(x y) and e = fma(x, y, -p)
 *   x - y = s + e exactly, with s = fl(x - y) and e what #double_double_difference gets back of
 * what s lost
 *
 * The products and differences are added up as pairs (Dekker, *A Floating-Point Technique for
 * Extending the Available Precision*, 1971).
 */
#include "lab/methods/real_functions.h"
#include "lab/methods/sphere.h"

/** A number as the sum of two: it, and what its rounding lost. */
typedef struct DoubleDouble {
    real value; /**< The number, rounded. */
    real error; /**< What is left of it. */
} DoubleDouble;

/** @return x - y. */
static DoubleDouble double_double_difference(real x, real y) {
    real s = x - y;
    real back = s - x;
    return (DoubleDouble){s, (x - (s - back)) - (y + back)};
}

/** @return x + y. */
static DoubleDouble double_double_sum(DoubleDouble x, DoubleDouble y) {
    DoubleDouble s = double_double_difference(x.value, -y.value);
    return (DoubleDouble){s.value, s.error + x.error + y.error};
}

/** @return The square of a pair. */
static DoubleDouble double_double_square(DoubleDouble x) {
    real p = x.value * x.value;
    return (DoubleDouble){p, real_fma(x.value, x.value, -p) + 2 * x.value * x.error};
}

/** @return |P0 - C|^2 - R^2. */
static real sphere_compensated_c(const SphereInput *in) {
    DoubleDouble radius_squared = double_double_square((DoubleDouble){in->radius, 0});
    DoubleDouble c = {-radius_squared.value, -radius_squared.error};
    c = double_double_sum(
        c, double_double_square(double_double_difference(in->origin.x, in->center.x)));
    c = double_double_sum(
        c, double_double_square(double_double_difference(in->origin.y, in->center.y)));
    c = double_double_sum(
        c, double_double_square(double_double_difference(in->origin.z, in->center.z)));
    return c.value + c.error;
}

/** Asks it. See #Method.run. */
static void sphere_compensated_run(const void *input, void *output) {
    const SphereInput *in = input;
    Vec3 d = in->direction, f = vec3_subtract(in->origin, in->center);
    real a = vec3_dot(d, d);
    real b = -vec3_dot(f, d);
    // The discriminant has two faces: from the axis where the sphere is far, from c where it is
    // near.
    Vec3 l = vec3_add(f, vec3_scale(d, b / a));
    real c = sphere_compensated_c(in);
    real from_axis = in->radius * in->radius - vec3_dot(l, l);
    real from_power = b * b / a - c;
    real discriminant = real_abs(b) < in->radius ? from_power : from_axis;
    real root = real_sqrt(a * discriminant);
    real far_sum = b > 0 ? b + root : b - root;
    real near = b > 0 ? c / far_sum : far_sum / a;
    real far = b > 0 ? far_sum / a : c / far_sum;
    ((SphereOutput *)output)->distance =
        discriminant >= 0 ? sphere_nearest_root(near, far) : INFINITE;
}

const Method sphere_compensated = {.group = "sphere",
                                   .name = "compensated",
                                   .label = "compensated",
                                   .input_count = NUMBERS_IN(SphereInput),
                                   .output_count = NUMBERS_IN(SphereOutput),
                                   .run = sphere_compensated_run};
