/**
 * @file
 * @brief Sphere.
 *
 * First the point of the ray nearest to the centre, by projection, then half the chord. All of it
 * is relative to the origin of the ray and in the wide precision: in float alone no formula
 * resolves the ground seen from above a sphere of 100 km (Haines, Günther, Akenine-Möller,
 * *Precision Improvements for Ray/Sphere Intersection*, Ray Tracing Gems 7). The root farther from
 * zero is a sum, the other one the quotient of the product of the roots: neither cancels.
 */
#include "trace/math/angle.h"
#include "trace/shapes/support.h"

/** Bound on the error of a point, in half ulps of its coordinates and of the radius. */
#define SPHERE_ERROR 8

/** A sphere. @extends Shape */
typedef struct Sphere {
    Shape base;         /**< Base. */
    Vec3sw center;      /**< Centre. */
    wide_scalar radius; /**< Radius. */
} Sphere;

/** A sphere, as the origins of LANES rays see it. */
typedef struct SeenSphere {
    Vec3w to_center;     /**< From the origin to the centre. */
    wide center_power;   /**< The square of its length, less that of the radius. */
    wide radius_squared; /**< The square of the radius. */
} SeenSphere;

/** The chords of LANES rays in a sphere. */
typedef struct SphereRoots {
    const SeenSphere *seen; /**< For rays of a beam; not set for others. */
    Vec3 mid_to_center;     /**< From the middle of the chord to the centre. */
    real half_chord;        /**< Half the chord, in lengths of the direction. */
    mask is_outside;        /**< Whether the ray starts outside: the first root counts. */
} SphereRoots;

/** See #ShapeClass.init. */
static void sphere_init(Shape *self, const void *parameters) {
    Sphere *sphere = (Sphere *)self;
    const SphereParameters *p = parameters;
    sphere->center = vec3sw_of(p->center);
    sphere->radius = (wide_scalar)p->radius;
}

/** @return A sphere as origins see it. */
INLINE SeenSphere sphere_seen_from(const Sphere *sphere, Vec3 origin) {
    Vec3w to_center = vec3w_subtract(vec3w_splat(sphere->center), vec3_widen(origin));
    wide radius_squared = wide_of(sphere->radius * sphere->radius);
    return (SeenSphere){to_center, vec3w_dot(to_center, to_center) - radius_squared,
                        radius_squared};
}

/** Solves |origin + t direction - center| = radius. See #IntersectFunction. */
INLINE mask seen_sphere_intersect(const SeenSphere *seen, const Ray *ray, mask active,
                                  real *distance, SphereRoots *chord) {
    // The point of the line that is nearest to the centre.
    const Vec3w to_center = seen->to_center;
    Vec3w direction = vec3_widen(ray->direction);
    wide per_length_squared = 1 / vec3w_dot(direction, direction);
    wide middle = vec3w_dot(to_center, direction) * per_length_squared;
    Vec3w mid_to_center = vec3w_add_scaled(to_center, direction, -middle);

    // Half the chord, from the right triangle of radius and distance.
    wide half_squared = seen->radius_squared - vec3w_dot(mid_to_center, mid_to_center);
    mask crosses = active & narrow_mask(wide_less_equal(wide_of(0), half_squared));
    if (!any(crosses)) {
        return crosses;
    }
    real half = narrow(wide_sqrt(half_squared * per_length_squared));

    // The root farther from zero is a sum, the other one follows from the product of both. The
    // squares stay in the wide precision: those of a very long direction would vanish in float.
    real to_middle = narrow(middle);
    mask is_ahead = to_middle > 0;
    real sum = to_middle + real_select(is_ahead, half, -half);
    real quotient = narrow(seen->center_power * per_length_squared / widen(sum));
    real near = real_select(is_ahead, quotient, sum), far = real_select(is_ahead, sum, quotient);
    chord->mid_to_center = vec3_narrow(mid_to_center);
    chord->half_chord = half;
    chord->is_outside = near > 0;
    *distance = real_select(chord->is_outside, near, far);
    return crosses;
}

/** See #IntersectFunction. */
INLINE mask sphere_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                             void *roots) {
    const SeenSphere seen = sphere_seen_from((const Sphere *)self, ray->origin);
    return seen_sphere_intersect(&seen, ray, active, distance, roots);
}

/** @return The points on a sphere. See #SurfaceFunction. */
INLINE SurfacePoint sphere_surface(const Shape *self, const Ray *ray, real distance,
                                   const void *roots) {
    (void)distance;
    const Sphere *sphere = (const Sphere *)self;
    const SphereRoots *chord = roots;
    // From the centre to the point: neither a difference of large numbers nor ever zero.
    real half = real_select(chord->is_outside, -chord->half_chord, chord->half_chord);
    Vec3 from_center = vec3_subtract(vec3_scale(ray->direction, half), chord->mid_to_center);
    // The point is one radius from the centre along the normal: exactly on the sphere.
    Vec3 normal = vec3_normalize(from_center);
    real radius = real_of((scalar)sphere->radius);
    Vec3 point = vec3_add(vec3_splat(vec3s_narrow(sphere->center)), vec3_scale(normal, radius));
    return (SurfacePoint){point, normal, SPHERE_ERROR * ROUNDOFF * (vec3_max_abs(point) + radius)};
}

/** See #ShapeClass.is_hit. @callgraph */
static mask sphere_is_hit(const Shape *self, const Ray *ray, mask active, Hit *hit) {
    SphereRoots roots;
    return primitive_is_hit(self, ray, active, hit, sphere_intersect, sphere_surface, &roots);
}

/** #sphere_intersect for rays of a beam. See #IntersectFunction. */
INLINE mask sphere_beam_intersect(const Shape *self, const Ray *ray, mask active, real *distance,
                                  void *roots) {
    (void)self;
    return seen_sphere_intersect(((SphereRoots *)roots)->seen, ray, active, distance, roots);
}

/** Sees the sphere once for all rays: they start at one point. See #ShapeClass.beam_hits. */
static bool sphere_beam_hits(const Shape *self, const Packet *packet, Hit *hits) {
    const SeenSphere seen = sphere_seen_from((const Sphere *)self, vec3_splat(packet->beam.origin));
    SphereRoots roots = {.seen = &seen};
    for (int v = 0; v < PACKET_VECTORS; v++) {
        primitive_is_hit(self, &packet->rays[v], packet->active[v], &hits[v], sphere_beam_intersect,
                         sphere_surface, &roots);
    }
    return true;
}

/** @return The rays that may meet a sphere: those that start outside and go away, as most shadow
 *          rays that leave it do, have no root above 0. NaN goes away. */
INLINE mask sphere_may_meet(const Sphere *sphere, const Ray *ray) {
    Vec3w to_center = vec3w_subtract(vec3w_splat(sphere->center), vec3_widen(ray->origin));
    wide along = vec3w_dot(to_center, vec3_widen(ray->direction));
    wide center_power = vec3w_dot(to_center, to_center) - wide_of(sphere->radius * sphere->radius);
    return narrow_mask(wide_less(wide_of(0), along)) |
           narrow_mask(wide_less_equal(center_power, wide_of(0)));
}

/** See #ShapeClass.is_occluding. */
static mask sphere_is_occluding(const Shape *self, const Ray *ray, mask active, real limit) {
    SphereRoots roots;
    if (!any(active & sphere_may_meet((const Sphere *)self, ray))) {
        return mask_of(false);
    }
    return primitive_is_occluding(self, ray, active, limit, sphere_intersect, &roots);
}

/** See #ShapeClass.support. */
static real sphere_support(const Shape *self, Vec3s from, Vec3 directions) {
    const Sphere *sphere = (const Sphere *)self;
    const scalar radius = (scalar)sphere->radius;
    return support_of_point(support_vector(from, sphere->center), radius, directions) +
           radius * real_sqrt(vec3_dot(directions, directions));
}

/** See #ShapeClass.misses_to_point. */
static bool sphere_misses_to_point(const Shape *self, const PacketIntervals *intervals) {
    const Sphere *sphere = (const Sphere *)self;
    return intervals_miss_sphere(intervals, sphere->center, sphere->radius);
}

/** See #ShapeClass.bounds. */
static Aabbs sphere_bounds(const Shape *self) {
    const Sphere *sphere = (const Sphere *)self;
    Vec3d center = {(double)sphere->center.x, (double)sphere->center.y, (double)sphere->center.z};
    double r = (double)sphere->radius;
    return aabbs_from_corners(vec3d_subtract(center, (Vec3d){r, r, r}),
                              vec3d_add(center, (Vec3d){r, r, r}));
}

/** @return Longitude and latitude, as on a map of the earth. The latitude is an arc tangent: an arc
 *  cosine is NaN where rounding makes a normal longer than 1. See #ShapeClass.texture_uv. */
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

/** Methods of `sphere`. */
const ShapeClass sphere_class = {
    .size = sizeof(Sphere),
    .form = FORM_CONVEX,
    .init = sphere_init,
    .is_hit = sphere_is_hit,
    .is_occluding = sphere_is_occluding,
    .support = METHOD_OF_BEAMS(sphere_support),
    .misses_to_point = METHOD_OF_BEAMS(sphere_misses_to_point),
    .beam_hits = METHOD_OF_BEAMS(sphere_beam_hits),
    .bounds = sphere_bounds,
    .texture_uv = sphere_texture_uv,
};
