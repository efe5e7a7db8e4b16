/**
 * @file
 * @brief Sphere.
 *
 * The ray's nearest point to the centre first, by projection, then half the chord; all relative to
 * the origin of the ray and in the wide precision, because no formula in float alone can see the
 * ground from a sphere of 100 km (Haines, Günther, Akenine-Möller, *Precision Improvements for
 * Ray/Sphere Intersection*, Ray Tracing Gems 7). The root farther from zero comes by addition, the
 * other by the product of the roots, so that neither cancels.
 */
#include "trace/shapes/sphere.h"

#include "trace/math/angle.h"
#include "trace/shapes/registry.h"

/** Half ulps of the coordinates, and of the radius, that a point can be off the sphere. */
#define SPHERE_ERROR 8

/** A sphere. @extends Shape */
typedef struct Sphere {
    Shape base;         /**< What all shapes have. */
    Vec3sw center;      /**< Its centre. */
    wide_scalar radius; /**< Its radius. */
} Sphere;

/** Where LANES rays cross a sphere. */
typedef struct SphereRoots {
    Vec3 mid_to_center; /**< From the chord's middle to the centre. */
    real half_chord;    /**< Half the chord, in lengths of the direction. */
    real near;          /**< The smaller root. */
    real far;           /**< The larger root. */
} SphereRoots;

/** Fields of `sphere`. */
static const Parameter sphere_parameters[] = {{.name = "center",
                                               .type = PARAMETER_POINT,
                                               .offset = offsetof(SphereParameters, center),
                                               .minimum = -LENGTH_MAXIMUM,
                                               .maximum = LENGTH_MAXIMUM,
                                               .unit = "scene units",
                                               .help = "its centre"},
                                              {.name = "radius",
                                               .type = PARAMETER_NUMBER,
                                               .offset = offsetof(SphereParameters, radius),
                                               .minimum = LENGTH_MINIMUM,
                                               .maximum = LENGTH_MAXIMUM,
                                               .unit = "scene units",
                                               .help = "its radius"},
                                              {0}};

/** A sphere of radius 1 at the origin. */
static const SphereParameters sphere_defaults = {.radius = 1};

/** Makes a sphere. */
static void sphere_init(Shape *self, const void *parameters) {
    Sphere *sphere = (Sphere *)self;
    const SphereParameters *p = parameters;
    sphere->center = vec3sw_of(p->center);
    sphere->radius = (wide_scalar)p->radius;
}

/**
 * Solves |origin + t direction - center| = radius.
 * @param[out] roots  The roots; NaN in lanes that miss.
 * @return The lanes whose line, forwards or backwards, meets the sphere.
 */
INLINE mask sphere_intersect(const Sphere *sphere, const Ray *ray, mask active,
                             SphereRoots *roots) {
    // The point of the line that is nearest to the centre.
    Vec3w direction = vec3_widen(ray->direction);
    Vec3w to_center = vec3w_subtract(vec3w_splat(sphere->center), vec3_widen(ray->origin));
    wide per_length_squared = 1 / vec3w_dot(direction, direction);
    wide middle = vec3w_dot(to_center, direction) * per_length_squared;
    Vec3w mid_to_center = vec3w_add_scaled(to_center, direction, -middle);

    // Half the chord, from the right triangle of radius and distance.
    wide radius_squared = wide_of(sphere->radius * sphere->radius);
    wide half_squared = radius_squared - vec3w_dot(mid_to_center, mid_to_center);
    mask crosses = active & narrow_mask(wide_less_equal(wide_of(0), half_squared));
    if (!any(crosses)) {
        return crosses;
    }
    real half = narrow(wide_sqrt(half_squared * per_length_squared));

    // The root farther from zero by a sum, the other by the product of the two. The squares stay in
    // the wide precision: those of a very long direction would vanish in float.
    real to_middle = narrow(middle);
    mask is_ahead = to_middle > 0;
    real sum = to_middle + real_select(is_ahead, half, -half);
    wide center_power = vec3w_dot(to_center, to_center) - radius_squared;
    real quotient = narrow(center_power * per_length_squared / widen(sum));
    roots->near = real_select(is_ahead, quotient, sum);
    roots->far = real_select(is_ahead, sum, quotient);
    roots->mid_to_center = vec3_narrow(mid_to_center);
    roots->half_chord = half;
    return crosses;
}

/** @return The lanes where the nearest root ahead counts. See #ShapeClass.is_hit. @callgraph */
static mask sphere_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Sphere *sphere = (const Sphere *)self;
    SphereRoots roots;
    mask crosses = sphere_intersect(sphere, ray, active, &roots);
    if (!any(crosses)) {
        return crosses;
    }
    mask is_outside = roots.near > 0;
    real distance = real_select(is_outside, roots.near, roots.far);
    mask nearer = hit_is_nearer(hit, crosses, distance, self->index);
    if (!any(nearer)) {
        return nearer;
    }

    // From the centre to the point: never a difference of large numbers, and never zero.
    real half = real_select(is_outside, -roots.half_chord, roots.half_chord);
    Vec3 from_center = vec3_subtract(vec3_scale(ray->direction, half), roots.mid_to_center);
    // The point is put back on the sphere: one radius long in the direction of the arm.
    Vec3 normal = vec3_normalize(from_center);
    real radius = real_of((scalar)sphere->radius);
    Vec3 point = vec3_add(vec3_splat(vec3s_narrow(sphere->center)), vec3_scale(normal, radius));
    Hit found = {distance,
                 point,
                 normal,
                 SPHERE_ERROR * ROUNDOFF * (vec3_max_abs(point) + radius),
                 integer_of(self->index),
                 integer_of(0)};
    hit_update(hit, nearer, &found);
    return nearer;
}

/** @return The lanes where a root lies on the way. See #ShapeClass.is_occluding. */
static mask sphere_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    SphereRoots roots;
    mask crosses = sphere_intersect((const Sphere *)self, ray, active, &roots);
    if (!any(crosses)) {
        return crosses;
    }
    real distance = real_select(roots.near > 0, roots.near, roots.far);
    return crosses & (distance > 0) & (distance < limit);
}

/** @return The box around a sphere. */
static Aabbs sphere_bounds(const Shape *self) {
    const Sphere *sphere = (const Sphere *)self;
    Vec3d center = {(double)sphere->center.x, (double)sphere->center.y, (double)sphere->center.z};
    double r = (double)sphere->radius;
    return aabbs_from_corners(vec3d_subtract(center, (Vec3d){r, r, r}),
                              vec3d_add(center, (Vec3d){r, r, r}));
}

/** @return Where on a picture points of a sphere lie: by longitude and latitude, like the earth on
 *  a map. The latitude by the arc tangent of its two legs, as an arc cosine is NaN where a rounded
 *  normal is longer than 1. See #ShapeClass.texture_uv. */
static TextureUv sphere_texture_uv(const Shape *self, const Hit *hit, mask lanes) {
    (void)self;
    (void)lanes;
    Vec3 n = hit->normal;
    real across = real_sqrt(n.x * n.x + n.z * n.z);
    return (TextureUv){.u = real_atan2_turns(n.x, n.z) + real_of((scalar)0.5f),
                       .v = 1 - 2 * real_atan2_turns(across, n.y),
                       .wrap_u = mask_of(true),
                       .wrap_v = mask_of(false)};
}

const ShapeClass sphere_class = {
    .keyword = {.name = "sphere",
                .help = "a ball",
                .parameters = sphere_parameters,
                .size = sizeof(SphereParameters),
                .defaults = &sphere_defaults},
    .size = sizeof(Sphere),
    .init = sphere_init,
    .is_hit = sphere_is_hit,
    .is_occluding = sphere_is_occluding,
    .bounds = sphere_bounds,
    .texture_uv = sphere_texture_uv,
};
