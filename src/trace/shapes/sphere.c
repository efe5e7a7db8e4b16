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

#include "trace/angle.h"
#include "trace/shapes/registry.h"

/** Half ulps of the coordinates, and of the radius, that a point can be off the sphere. */
#define SPHERE_ERROR 8

/** A sphere. @extends Shape */
typedef struct Sphere {
    Shape base;         /**< What all shapes have. */
    WidePoint center;   /**< Its centre. */
    wide_scalar radius; /**< Its radius. */
} Sphere;

/** Where LANES rays cross a sphere. */
typedef struct Chord {
    Vector away; /**< From the chord's middle to the centre. */
    real half;   /**< Half the chord, in lengths of the direction. */
    real near;   /**< The smaller root. */
    real far;    /**< The larger root. */
} Chord;

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

/** Makes a sphere. @param self The sphere. @param parameters A #SphereParameters. */
static void sphere_init(Shape *self, const void *parameters) {
    Sphere *sphere = (Sphere *)self;
    const SphereParameters *p = parameters;
    sphere->center = wide_point_of(p->center);
    sphere->radius = (wide_scalar)p->radius;
}

/**
 * Solves |origin + t direction - center| = radius.
 * @param sphere      The sphere.
 * @param ray         The rays.
 * @param active      The lanes that count.
 * @param[out] chord  The roots; NaN in lanes that miss.
 * @return The lanes whose line, forwards or backwards, meets the sphere.
 */
INLINE mask sphere_chord(const Sphere *sphere, const Ray *ray, mask active, Chord *chord) {
    // The point of the line that is nearest to the centre.
    WideVector direction = vector_widen(ray->direction);
    WideVector to_center = wide_subtract(wide_vector_of(sphere->center), vector_widen(ray->origin));
    wide per_length_squared = 1 / wide_dot(direction, direction);
    wide middle = wide_dot(to_center, direction) * per_length_squared;
    WideVector away = wide_add_scaled(to_center, direction, -middle);

    // Half the chord, from the right triangle of radius and distance.
    wide radius_squared = wide_of(sphere->radius * sphere->radius);
    wide half_squared = radius_squared - wide_dot(away, away);
    mask crosses = active & narrow_mask(wide_at_most(wide_of(0), half_squared));
    if (!any(crosses)) {
        return crosses;
    }
    real half = narrow(wide_sqrt(half_squared * per_length_squared));

    // The root farther from zero by a sum, the other by the product of the two. The squares stay in
    // the wide precision: those of a very long direction would vanish in float.
    real to_middle = narrow(middle);
    mask is_ahead = to_middle > 0;
    real sum = to_middle + real_select(is_ahead, half, -half);
    wide power = wide_dot(to_center, to_center) - radius_squared;
    real quotient = narrow(power * per_length_squared / widen(sum));
    chord->near = real_select(is_ahead, quotient, sum);
    chord->far = real_select(is_ahead, sum, quotient);
    chord->away = vector_narrow(away);
    chord->half = half;
    return crosses;
}

/** @return The lanes where the nearest root ahead counts. See #ShapeClass.is_hit. @callgraph
 *  @param self The sphere. @param ray The rays. @param active The lanes. @param[in,out] hit The
 * hit.
 */
static mask sphere_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    const Sphere *sphere = (const Sphere *)self;
    Chord chord;
    mask crosses = sphere_chord(sphere, ray, active, &chord);
    if (!any(crosses)) {
        return crosses;
    }
    mask is_outside = chord.near > 0;
    real distance = real_select(is_outside, chord.near, chord.far);
    mask nearer = hit_is_nearer(hit, crosses, distance, self->place);
    if (!any(nearer)) {
        return nearer;
    }

    // From the centre to the point: never a difference of large numbers, and never zero.
    real half = real_select(is_outside, -chord.half, chord.half);
    Vector arm = vector_subtract(vector_scale(ray->direction, half), chord.away);
    // The point is put back on the sphere: one radius long in the direction of the arm.
    Vector normal = vector_normalize(arm);
    real radius = real_of((scalar)sphere->radius);
    Vector point =
        vector_add(vector_of_point(point_narrow(sphere->center)), vector_scale(normal, radius));
    Hit found = {distance,
                 point,
                 normal,
                 SPHERE_ERROR * ROUNDOFF * (vector_largest(point) + radius),
                 integer_of(self->place),
                 integer_of(0)};
    hit_take(hit, nearer, &found);
    return nearer;
}

/** @return The lanes where a root lies on the way. See #ShapeClass.is_blocking.
 *  @param self The sphere. @param ray The rays. @param active The lanes. @param limit The way's
 * end.
 */
static mask sphere_is_blocking(const Shape *self, const Ray *ray, mask active, real limit) {
    Chord chord;
    mask crosses = sphere_chord((const Sphere *)self, ray, active, &chord);
    if (!any(crosses)) {
        return crosses;
    }
    real distance = real_select(chord.near > 0, chord.near, chord.far);
    return crosses & (distance > 0) & (distance < limit);
}

/** @return The box around a sphere. @param self The sphere. */
static Bounds sphere_bounds(const Shape *self) {
    const Sphere *sphere = (const Sphere *)self;
    Vector3 center = {(double)sphere->center.x, (double)sphere->center.y, (double)sphere->center.z};
    double r = (double)sphere->radius;
    return bounds_around(vector3_subtract(center, (Vector3){r, r, r}),
                         vector3_add(center, (Vector3){r, r, r}));
}

/**
 * @return Where on a picture points of a sphere lie: by longitude and latitude, like the earth on a
 *         map. The latitude by the arc tangent of its two legs, as an arc cosine is NaN where a
 *         rounded normal is longer than 1. See #ShapeClass.texture_place.
 * @param self   Not looked at.
 * @param hit    The points.
 * @param lanes  Not looked at.
 */
static TexturePlace sphere_texture_place(const Shape *self, const Hit *hit, mask lanes) {
    (void)self;
    (void)lanes;
    Vector n = hit->normal;
    real across = real_sqrt(n.x * n.x + n.z * n.z);
    return (TexturePlace){.u = angle_in_turns(n.x, n.z) + real_of((scalar)0.5f),
                          .v = 1 - 2 * angle_in_turns(across, n.y),
                          .around_u = mask_of(true),
                          .around_v = mask_of(false)};
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
    .is_blocking = sphere_is_blocking,
    .bounds = sphere_bounds,
    .texture_place = sphere_texture_place,
};
