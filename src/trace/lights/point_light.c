/**
 * @file
 * @brief Point lights, and spherical lights around them.
 *
 * A sphere of uniform radiance L lights a point outside as its centre would, if nothing hides a
 * part of it: pi L (r / d)^2 cos. So the light is the same whatever the radius, and L = I / (pi
 * r^2). The rays to a spherical light are spread evenly over the cone that it fills, of half-angle
 * a with sin a = r / d. The cone's solid angle is 2 pi (1 - cos a), and L times it, divided by what
 * the centre gives, I / d^2, is the weight of one ray:
 *
 *     2 (1 - cos a) / sin^2 a = 2 / (1 + cos a)
 *
 * (Shirley, Wang, Zimmerman, *Monte Carlo Techniques for Direct Lighting Calculations*, 1996).
 */
#include "trace/lights/light.h"

/** A point light's own struct. */
typedef struct LIGHT_OWN PointLight {
    Vec3 position; /**< The point, or the sphere's centre. */
    real radius;   /**< The sphere's; 0: a point. */
} PointLight;

/** Samples a point. See #LightSampler. */
static void point_light_sample(const Light *light, size_t light_index, const RayOffset *offset,
                               const SurfaceHit *surface, LightSample *sample) {
    (void)light_index;
    light_sample_center(&((const PointLight *)light_own(light))->position, offset, surface, sample);
}

/** Samples the centre of a sphere. The rays end at the sphere: shapes inside are not in the way.
 *  See #LightSampler. */
static void sphere_light_sample_center(const Light *light, size_t light_index,
                                       const RayOffset *offset, const SurfaceHit *surface,
                                       LightSample *sample) {
    point_light_sample(light, light_index, offset, surface, sample);
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        real t_end = 1 - ((const PointLight *)light_own(light))->radius /
                             real_sqrt(sample->distance_squared[v]);
        sample->shadow_rays.limit[v] = real_max(t_end, real_of(0));
    }
}

/** LANES points of the unit disc. */
typedef struct DiscPoint {
    real x; /**< Across. */
    real y; /**< Up. */
} DiscPoint;

/** @return The sine of an eighth of a turn times s. */
INLINE real sine_of_eighth_turn(real s) {
    // Taylor's series to the ninth power: off by less than 2e-9.
    real x = s * (scalar)0.78539816339744830961, square = x * x;
    real sum = 1 - square / 72;
    sum = 1 - square / 42 * sum;
    sum = 1 - square / 20 * sum;
    return x * (1 - square / 6 * sum);
}

/** @return Points of the unit disc, as evenly spread as those of the square: squares around the
 *          middle become circles (Shirley, Chiu, *A Low Distortion Map Between Disk and Square*,
 *          1997). */
INLINE DiscPoint concentric_disc_map(SquareSample square) {
    real a = square.a, b = square.b;
    mask is_wide = real_abs(a) > real_abs(b);
    real radius = real_select(is_wide, a, b), other = real_select(is_wide, b, a);
    real ratio = real_select(radius == 0, real_of(0), other / radius);
    real sine = sine_of_eighth_turn(ratio), along = radius * real_sqrt(1 - sine * sine);
    real across = radius * sine;
    return (DiscPoint){real_select(is_wide, along, across), real_select(is_wide, across, along)};
}

/**
 * @return Directions within the cone that a sphere fills.
 * @param axis  Unit vectors to the sphere's centre.
 * @param one_minus_cos  1 - cos a of the cone.
 * @param disc  Where in the cone.
 */
INLINE Vec3 cone_sample(Vec3 axis, real one_minus_cos, DiscPoint disc) {
    // Two vectors at right angles (Duff and others, *Building an Orthonormal Basis, Revisited*,
    // 2017).
    real sign = real_select(axis.z < 0, real_of(-1), real_of(1));
    real a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
    Vec3 across = {1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
    Vec3 up = {b, sign + axis.y * axis.y * a, -axis.y};
    // A point's fraction of the disc is its direction's fraction of the cone.
    real fraction = disc.x * disc.x + disc.y * disc.y;
    real sin_theta = real_sqrt(one_minus_cos * (2 - fraction * one_minus_cos));
    Vec3 offset =
        vec3_add(vec3_scale(across, disc.x * sin_theta), vec3_scale(up, disc.y * sin_theta));
    return vec3_normalize(vec3_add(offset, vec3_scale(axis, 1 - fraction * one_minus_cos)));
}

/** Samples the sphere by solid angle. See #LightSampler. */
static void sphere_light_sample(const Light *light, size_t light_index, const RayOffset *offset,
                                const SurfaceHit *surface, LightSample *sample) {
    const PointLight *sphere = light_own(light);
    real radius_squared = sphere->radius * sphere->radius;
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        sample->shadow_rays.active[v] = surface->needs_light[v];
        if (!any(surface->needs_light[v])) {
            continue;
        }
        Vec3 to_light = vec3_subtract(sphere->position, surface->hits[v].point);
        real distance_squared =
            real_max(vec3_dot(to_light, to_light), real_of(MIN_DISTANCE_SQUARED));
        real distance = real_sqrt(distance_squared);
        real sine_squared = real_min(radius_squared / distance_squared, real_of(1));
        real cosine = real_sqrt(1 - sine_squared), one_minus_cos = sine_squared / (1 + cosine);
        DiscPoint disc =
            concentric_disc_map(light_square_sample(&surface->packet->context, light_index, v));
        Vec3 direction = cone_sample(vec3_scale(to_light, 1 / distance), one_minus_cos, disc);
        // The ray ends where it meets the sphere: half a chord before its point nearest the centre.
        real along = vec3_dot(to_light, direction);
        real half_chord_squared = radius_squared - (distance_squared - along * along);
        real end = along - real_sqrt(real_max(half_chord_squared, real_of(0)));
        light_sample_set_point(offset, surface, v, direction, end, distance_squared,
                               2 / (1 + cosine), sample);
    }
}

/** Fills a point light or a spherical one. See #LightClass.init. */
static void point_light_init(Light *self, const SceneLight *said, int samples) {
    scalar radius = (scalar)said->radius;
    *(PointLight *)self->own = (PointLight){vec3_of(said->position), real_of(radius)};
    self->is_visible = radius > 0;
    self->is_soft = self->is_visible && samples > 1;
    self->is_point = !self->is_visible;
    self->position = vec3_of(said->position);
    self->sample = self->is_soft      ? sphere_light_sample
                   : self->is_visible ? sphere_light_sample_center
                                      : point_light_sample;
    // Within the sphere the light is as strong as on its surface.
    light_set_min_distance_squared(self, radius * radius);
}

/** Fills a sphere. See #LightClass.emitter_init. */
static void point_light_emitter_init(Shape *emitter, const SceneLight *said) {
    sphere_class.init(emitter, &(SphereParameters){said->position, said->radius});
}

/** The class of `light`. */
extern const LightClass point_light_class;

const LightClass point_light_class = {
    .init = point_light_init, .emitter = &sphere_class, .emitter_init = point_light_emitter_init};
