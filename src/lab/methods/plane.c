/**
 * @file
 * @brief Where does a ray hit a plane?
 */
#include "lab/methods/family.h"

/** A ray and a plane. */
typedef struct PlaneInput {
    Vec3 origin;    /**< Origin of the ray: P0. */
    Vec3 direction; /**< Direction: d. */
    Vec3 point;     /**< A point of the plane: Q. */
    Vec3 normal;    /**< Normal of the plane: N. */
    real offset;    /**< N.Q, computed in quad and rounded once. */
} PlaneInput;

/** The hit. */
typedef struct PlaneOutput {
    real distance; /**< In lengths of the direction; NaN or infinite: the ray is parallel. */
} PlaneOutput;

/**
 * By a point of the plane, as in reports C and D (doc/reports.md).
 *
 *   t = (Q - P0).N / d.N
 *
 * Q - P0 is long where the point is far away, and its product with N cancels.
 */
METHOD(plane_point_normal, PlaneInput, PlaneOutput) {
    real height = vec3_dot(vec3_subtract(in->point, in->origin), in->normal);
    return (PlaneOutput){height / vec3_dot(in->direction, in->normal)};
}

/**
 * By the plane equation, with the offset D computed once.
 *
 *   D = N.Q,  t = (D - N.P0) / d.N
 */
METHOD(plane_equation, PlaneInput, PlaneOutput) {
    real height = in->offset - vec3_dot(in->normal, in->origin);
    return (PlaneOutput){height / vec3_dot(in->direction, in->normal)};
}

/**
 * Quilez, `plaIntersect` of his *Intersectors* (MIT licence; see doc/references.md).
 *
 *   t = -(P0.N + w) / d.N,  w = -N.Q
 *
 * #plane_equation with the terms in another order.
 */
METHOD(plane_quilez, PlaneInput, PlaneOutput) {
    real height = vec3_dot(in->origin, in->normal) - in->offset;
    return (PlaneOutput){-height / vec3_dot(in->direction, in->normal)};
}

const MethodFamily plane_family = {
    FAMILY("plane", PlaneInput, PlaneOutput),
    (const Method[]){{"by a point", "by a point", plane_point_normal_run},
                     {"by its offset", "by its offset", plane_equation_run},
                     {"Quilez", "Quilez", plane_quilez_run},
                     {0}}};
