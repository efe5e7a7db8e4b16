/**
 * @file
 * @brief Where does a ray first hit a sphere?
 *
 * In the formulas P0 is the ray's origin, d its direction, C the centre, R the radius, t the
 * distance along the ray. Doc/laboratory.md shows where each formula fails.
 */
#include "lab/methods/family.h"

/** A ray and a sphere. */
typedef struct SphereInput {
    Vec3 origin;    /**< Origin of the ray: P0. */
    Vec3 direction; /**< Direction, of length 1 but for rounding: d. */
    Vec3 center;    /**< Centre of the sphere: C. */
    real radius;    /**< Radius of the sphere: R. */
} SphereInput;

/** The nearest hit. */
typedef struct SphereOutput {
    real distance; /**< In lengths of the direction; #INFINITE: the ray misses. */
} SphereOutput;

/** @return The nearest root ahead. @param discriminant Below 0 or NaN: the ray misses. */
static SphereOutput sphere_output(real discriminant, real near, real far) {
    return (SphereOutput){discriminant >= 0 ? nearest_positive_root(near, far) : INFINITE};
}

/**
 * Expanded quadratic, as in report A (doc/reports.md).
 *
 *   a t^2 + b t + c = 0,  a = d.d,  b = 2 (d.P0 - d.C),  c = P0.P0 + C.C - 2 P0.C - R^2
 *
 * c is a difference of squared coordinates: far from the world's origin all its digits cancel.
 * b^2 and 4ac share their leading digits where the sphere is far from the ray's origin.
 */
METHOD(sphere_expanded, SphereInput, SphereOutput) {
    Vec3 p = in->origin, d = in->direction, center = in->center;
    real a = vec3_dot(d, d);
    real b = 2 * (vec3_dot(d, p) - vec3_dot(d, center));
    real c = vec3_dot(p, p) + vec3_dot(center, center) - 2 * vec3_dot(p, center) -
             in->radius * in->radius;
    real discriminant = b * b - 4 * a * c;
    real root = real_sqrt(discriminant);
    return sphere_output(discriminant, (-b - root) / (2 * a), (-b + root) / (2 * a));
}

/**
 * Textbook quadratic, relative to the centre.
 *
 *   f = P0 - C,  a = d.d,  b = 2 f.d,  c = f.f - R^2,  t = (-b -+ sqrt(b^2 - 4 a c)) / 2 a
 *
 * No coordinate is squared, but b^2 and 4ac still share their leading digits: the error of t
 * over R grows as k^2 half ulps, where k is the distance over the radius.
 */
METHOD(sphere_textbook, SphereInput, SphereOutput) {
    Vec3 f = vec3_subtract(in->origin, in->center), d = in->direction;
    real a = vec3_dot(d, d);
    real b = 2 * vec3_dot(f, d);
    real c = vec3_dot(f, f) - in->radius * in->radius;
    real discriminant = b * b - 4 * a * c;
    real root = real_sqrt(discriminant);
    return sphere_output(discriminant, (-b - root) / (2 * a), (-b + root) / (2 * a));
}

/**
 * Projection of the centre onto the ray, in world coordinates, as in report C.
 *
 *   l = (C - P0).d,  H = P0 + l d,  h^2 = R^2 - |H - C|^2,  t = l -+ h
 *
 * H is the point of the line nearest to the centre, rounded as coordinates are. Far from the
 * world's origin H - C is mostly rounding error.
 */
METHOD(sphere_projection, SphereInput, SphereOutput) {
    Vec3 d = in->direction;
    real l = vec3_dot(vec3_subtract(in->center, in->origin), d);
    Vec3 nearest = vec3_add(in->origin, vec3_scale(d, l));
    Vec3 v = vec3_subtract(nearest, in->center);
    real h_squared = in->radius * in->radius - vec3_dot(v, v);
    real h = real_sqrt(h_squared);
    return sphere_output(h_squared, l - h, l + h);
}

/**
 * The same projection, relative to the ray's origin.
 *
 *   f = C - P0,  l = f.d,  v = l d - f,  h^2 = R^2 - v.v,  t = l -+ h
 *
 * P0 is never added back: the error of |v| is half an ulp of the distance, anywhere in the world.
 */
METHOD(sphere_projection_relative, SphereInput, SphereOutput) {
    Vec3 d = in->direction, f = vec3_subtract(in->center, in->origin);
    real l = vec3_dot(f, d);
    Vec3 v = vec3_subtract(vec3_scale(d, l), f);
    real h_squared = in->radius * in->radius - vec3_dot(v, v);
    real h = real_sqrt(h_squared);
    return sphere_output(h_squared, l - h, l + h);
}

/**
 * A discriminant without cancellation, and the near root as a quotient (Haines, Günther,
 * Akenine-Möller, *Precision Improvements for Ray/Sphere Intersection*, Ray Tracing Gems 7).
 *
 *   f = P0 - C,  a = d.d,  b = -f.d,  l = f + (b / a) d,  D = R^2 - l.l,  c = f.f - R^2
 *   q = b + sign(b) sqrt(a D),  t = c / q and q / a
 *
 * The product of the roots is c / a, so the root that cancels as a difference is computed as a
 * quotient. c itself remains: near the surface of a large sphere it is a difference of large
 * squares.
 */
METHOD(sphere_stable_quadratic, SphereInput, SphereOutput) {
    Vec3 d = in->direction, f = vec3_subtract(in->origin, in->center);
    real a = vec3_dot(d, d);
    real b = -vec3_dot(f, d);
    Vec3 l = vec3_add(f, vec3_scale(d, b / a));
    real discriminant = in->radius * in->radius - vec3_dot(l, l);
    real c = vec3_dot(f, f) - in->radius * in->radius;
    real root = real_sqrt(a * discriminant);
    real sum = b > 0 ? b + root : b - root;
    real near = b > 0 ? c / sum : sum / a;
    real far = b > 0 ? sum / a : c / sum;
    return sphere_output(discriminant, near, far);
}

/**
 * The same formula in the next wider type, which the tracer's own spheres use in float.
 *
 * Float is widened to double. Double, long double and quad have no fast wider type: there this is
 * #sphere_stable_quadratic again.
 */
METHOD(sphere_mixed_precision, SphereInput, SphereOutput) {
    Vec3w d = vec3_widen(in->direction);
    Vec3w f = vec3w_subtract(vec3_widen(in->origin), vec3_widen(in->center));
    wide a = vec3w_dot(d, d), radius = widen(in->radius);
    wide b = -vec3w_dot(f, d);
    Vec3w l = vec3w_add_scaled(f, d, b / a);
    wide discriminant = radius * radius - vec3w_dot(l, l);
    wide c = vec3w_dot(f, f) - radius * radius;
    wide root = wide_sqrt(a * discriminant);
    wide sum = b > 0 ? b + root : b - root;
    wide near = b > 0 ? c / sum : sum / a;
    wide far = b > 0 ? sum / a : c / sum;
    real distance = nearest_positive_root(narrow(near), narrow(far));
    return (SphereOutput){discriminant >= 0 ? distance : INFINITE};
}

/** A number as the sum of two: twice the mantissa of the number type. */
typedef struct DoubleDouble {
    real value; /**< The number, rounded. */
    real error; /**< Its rounding error. */
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

/** @return x^2. */
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

/**
 * The stable quadratic, with c = |P0 - C|^2 - R^2 in compensated arithmetic (Dekker, *A
 * Floating-Point Technique for Extending the Available Precision*, 1971).
 *
 *   x y = p + e exactly, with p = fl(x y) and e = fma(x, y, -p)
 *   x - y = s + e exactly, with s = fl(x - y) and e from #double_double_difference
 *
 * c has twice the precision of the number type, and no wider type is needed.
 */
METHOD(sphere_compensated, SphereInput, SphereOutput) {
    Vec3 d = in->direction, f = vec3_subtract(in->origin, in->center);
    real a = vec3_dot(d, d);
    real b = -vec3_dot(f, d);
    // Two equal formulas: from the distance to the axis where the sphere is far, from c where it
    // is near.
    Vec3 l = vec3_add(f, vec3_scale(d, b / a));
    real c = sphere_compensated_c(in);
    real from_axis = in->radius * in->radius - vec3_dot(l, l);
    real from_power = b * b / a - c;
    real discriminant = real_abs(b) < in->radius ? from_power : from_axis;
    real root = real_sqrt(a * discriminant);
    real far_sum = b > 0 ? b + root : b - root;
    real near = b > 0 ? c / far_sum : far_sum / a;
    real far = b > 0 ? far_sum / a : c / far_sum;
    return sphere_output(discriminant, near, far);
}

/**
 * Quilez, `sphIntersect` of his *Intersectors* (MIT licence; see doc/references.md).
 *
 *   f = P0 - C,  b = f.d,  q = f - b d,  h = R^2 - q.q,  t = -b -+ sqrt(h)
 *
 * #sphere_projection_relative with other signs: c is never computed. As he has it, t = -b - sqrt(h)
 * alone; here the ray may also start inside.
 */
METHOD(sphere_quilez, SphereInput, SphereOutput) {
    Vec3 f = vec3_subtract(in->origin, in->center), d = in->direction;
    real b = vec3_dot(f, d);
    Vec3 q = vec3_subtract(f, vec3_scale(d, b));
    real h = in->radius * in->radius - vec3_dot(q, q);
    real root = real_sqrt(h);
    return sphere_output(h, -b - root, -b + root);
}

const MethodFamily sphere_family = {
    FAMILY("sphere", SphereInput, SphereOutput),
    (const Method[]){{"expanded", "expanded", sphere_expanded_run},
                     {"textbook", "textbook", sphere_textbook_run},
                     {"projection", "projection", sphere_projection_run},
                     {"relative projection", "relative", sphere_projection_relative_run},
                     {"Haines", "Haines", sphere_stable_quadratic_run},
                     {"mixed", "mixed", sphere_mixed_precision_run},
                     {"compensated", "compensated", sphere_compensated_run},
                     {"Quilez", "Quilez", sphere_quilez_run},
                     {0}}};
