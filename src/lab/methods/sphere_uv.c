/**
 * @file
 * @brief What is the latitude of a point on a sphere?
 */
#include "lab/methods/family.h"

/** A point of a sphere. */
typedef struct SphereUvInput {
    Vec3 point;  /**< The point, rounded as a hit point is: P. */
    Vec3 center; /**< Centre of the sphere: C. */
    real radius; /**< Radius of the sphere: R. */
} SphereUvInput;

/** Its latitude. */
typedef struct SphereUvOutput {
    real polar_angle; /**< From the upper pole, radians. */
} SphereUvOutput;

/**
 * Arc cosine, as in report A (doc/reports.md).
 *
 *   angle = acos((P.y - C.y) / R)
 *
 * At the pole the quotient may be rounded above 1, where the arc cosine is NaN. Near 1 the arc
 * cosine turns a last bit into a large angle.
 */
METHOD(sphere_uv_acos, SphereUvInput, SphereUvOutput) {
    return (SphereUvOutput){real_acos((in->point.y - in->center.y) / in->radius)};
}

/**
 * Arc cosine of a clamped quotient.
 *
 *   angle = acos(min(1, max(-1, (P.y - C.y) / R)))
 *
 * Never NaN, but a last bit is still a large angle.
 */
METHOD(sphere_uv_acos_clamped, SphereUvInput, SphereUvOutput) {
    real y = (in->point.y - in->center.y) / in->radius;
    y = y > 1 ? 1 : y < -1 ? -1 : y;
    return (SphereUvOutput){real_acos(y)};
}

/**
 * Arc tangent, as the tracer computes it.
 *
 *   angle = atan2(sqrt(x^2 + z^2), y), of P - C
 */
METHOD(sphere_uv_atan2, SphereUvInput, SphereUvOutput) {
    Vec3 n = vec3_subtract(in->point, in->center);
    return (SphereUvOutput){real_atan2(real_sqrt(n.x * n.x + n.z * n.z), n.y)};
}

const MethodFamily sphere_uv_family = {
    FAMILY("latitude", SphereUvInput, SphereUvOutput),
    (const Method[]){{"acos", "acos", sphere_uv_acos_run},
                     {"acos held", "acos held", sphere_uv_acos_clamped_run},
                     {"atan2", "atan2", sphere_uv_atan2_run},
                     {0}}};
