/**
 * @file
 * @brief What is the normal of a distance field?
 *
 * The field f is the signed distance to a sphere with the centre C. P is the point, h a step.
 */
#include "lab/methods/family.h"

/** A point on the surface of a sphere. */
typedef struct GradientInput {
    Vec3 point;  /**< P. */
    Vec3 center; /**< C. */
    real radius; /**< Radius of the sphere. */
    real step;   /**< h. */
} GradientInput;

/** The normal. */
typedef struct GradientOutput {
    Vec3 normal; /**< Of length 1 but for rounding. */
} GradientOutput;

/** @return f(P + (dx, dy, dz)). */
static real gradient_sphere_sdf(const GradientInput *in, real dx, real dy, real dz) {
    Vec3 position = vec3_add(in->point, (Vec3){dx, dy, dz});
    Vec3 local = vec3_subtract(position, in->center);
    return real_sqrt(vec3_dot(local, local)) - in->radius;
}

/**
 * Forward differences, as in report B (doc/reports.md).
 *
 *   f(P + h ex) - f(P) and so on: four values, an error of the order of h
 */
METHOD(gradient_forward, GradientInput, GradientOutput) {
    real h = in->step, here = gradient_sphere_sdf(in, 0, 0, 0);
    Vec3 n = {gradient_sphere_sdf(in, h, 0, 0) - here, gradient_sphere_sdf(in, 0, h, 0) - here,
              gradient_sphere_sdf(in, 0, 0, h) - here};
    return (GradientOutput){vec3_normalize(n)};
}

/**
 * Differences at the corners of a tetrahedron (Quilez, *Normals for an SDF*, 2015).
 *
 *   the sum of k f(P + h k) over k = (+--), (--+), (-+-), (+++)
 *
 * Four values. The mixed second derivatives, which cancel in central differences, remain: an error
 * of the order of h.
 */
METHOD(gradient_tetrahedral, GradientInput, GradientOutput) {
    real h = in->step, a = gradient_sphere_sdf(in, h, -h, -h),
         b = gradient_sphere_sdf(in, -h, -h, h);
    real c = gradient_sphere_sdf(in, -h, h, -h), d = gradient_sphere_sdf(in, h, h, h);
    Vec3 n = {a - b - c + d, -a - b + c + d, -a + b - c + d};
    return (GradientOutput){vec3_normalize(n)};
}

/**
 * Central differences.
 *
 *   f(P + h ex) - f(P - h ex) and so on: six values, an error of the order of h^2
 */
METHOD(gradient_central, GradientInput, GradientOutput) {
    real h = in->step;
    Vec3 n = {gradient_sphere_sdf(in, h, 0, 0) - gradient_sphere_sdf(in, -h, 0, 0),
              gradient_sphere_sdf(in, 0, h, 0) - gradient_sphere_sdf(in, 0, -h, 0),
              gradient_sphere_sdf(in, 0, 0, h) - gradient_sphere_sdf(in, 0, 0, -h)};
    return (GradientOutput){vec3_normalize(n)};
}

/**
 * The gradient in closed form.
 *
 *   (P - C) / |P - C|
 */
METHOD(gradient_analytic, GradientInput, GradientOutput) {
    return (GradientOutput){vec3_normalize(vec3_subtract(in->point, in->center))};
}

const MethodFamily gradient_family = {
    FAMILY("gradient", GradientInput, GradientOutput),
    (const Method[]){{"forward", "forward", gradient_forward_run},
                     {"tetrahedral", "tetrahedral", gradient_tetrahedral_run},
                     {"central", "central", gradient_central_run},
                     {"exact", "exact", gradient_analytic_run},
                     {0}}};
