/**
 * @file
 * @brief Aiming at lamps and suns.
 *
 * A ball that glows alike all over lights a point outside as its centre would, if nothing hides a
 * part of it: pi L (r / d)^2 cos, L being how bright it looks. So the light of a lamp is the same
 * whatever its radius, and L = I / (pi r^2). A soft lamp's rays are spread evenly over the cone
 * that the ball fills, of half-angle a with sin a = r / d. The cone's solid angle is 2 pi (1 - cos
 * a), and L times it, divided by what the centre gives, I / d^2, is the weight of one ray:
 *
 *     2 (1 - cos a) / sin^2 a = 2 / (1 + cos a)
 *
 * (Shirley, Wang, Zimmerman, *Monte Carlo Techniques for Direct Lighting Calculations*, 1996).
 */
#include "trace/lights/light.h"

#include "trace/math/sobol.h"

/** Squares of distances below this, of the smallest length that a scene may hold, count as this. */
#define MIN_DISTANCE_SQUARED ((scalar)(LENGTH_MINIMUM * LENGTH_MINIMUM))

/** No lamp gives more light than this at any point, so that sums stay finite in float. */
#define MAX_RADIANCE ((scalar)1e30)

/** @return The square of the distance from which on a lamp weakens. Within its ball it is as bright
 *  as at the ball, and nowhere brighter than a number can hold. */
static scalar min_distance_squared_of(scalar radius, Rgbs light) {
    scalar min_squared = radius * radius, max_channel = 1;
    max_channel = light.red > max_channel ? light.red : max_channel;
    max_channel = light.green > max_channel ? light.green : max_channel;
    max_channel = light.blue > max_channel ? light.blue : max_channel;
    scalar min_for_finite = max_channel / MAX_RADIANCE;
    min_squared = min_squared > MIN_DISTANCE_SQUARED ? min_squared : MIN_DISTANCE_SQUARED;
    return min_squared > min_for_finite ? min_squared : min_for_finite;
}

Rgbs scene_light_rgb(const SceneLight *light) {
    scalar intensity = (scalar)light->intensity;
    Rgbs color = rgbs_of(light->color);
    return (Rgbs){color.red * intensity, color.green * intensity, color.blue * intensity};
}

Light light_of(const SceneLight *light, int samples) {
    bool is_sun = light->kind == SCENE_LIGHT_SUN, is_spherical = scene_light_is_spherical(light);
    scalar radius = is_spherical ? (scalar)light->radius : 0;
    Rgbs bright = scene_light_rgb(light);
    Vec3d position = light->position;
    if (is_sun) {
        position = vec3d_scale(vec3d_normalize(vec3d_scale_exponent(light->direction)), -1);
    }
    return (Light){.position = vec3_of(position),
                   .intensity = rgb_splat(bright),
                   .is_sun = is_sun,
                   .radius = radius,
                   .min_distance_squared = min_distance_squared_of(radius, bright),
                   .is_inverse_square = !is_sun && light->falloff == FALLOFF_INVERSE_SQUARE,
                   .is_soft = is_spherical && samples > 1};
}

/**
 * Notes what points could get from a lamp along one ray each.
 * @param v  Which vector of them.
 * @param to_light  From them to the lamp.
 */
INLINE void light_sample_set(const SurfaceHit *surface, int v, Vec3 to_light, LightSample *sample) {
    real distance_squared = real_max(vec3_dot(to_light, to_light), real_of(MIN_DISTANCE_SQUARED));
    real cosine = vec3_dot(surface->n_front[v], to_light) / real_sqrt(distance_squared);
    sample->shadow_rays.active[v] = surface->needs_light[v] & (cosine > 0);
    sample->cosine[v] = cosine;
    sample->distance_squared[v] = distance_squared;
}

/** Aims at a sun. See #light_sample_packet. @param offset Where the rays start. */
static void sample_sun(const Light *light, const RayOffset *offset, const SurfaceHit *surface,
                       LightSample *sample) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        Vec3 to_light = light->position,
             origin = ray_offset_origin(offset, &surface->hits[v], to_light);
        light_sample_set(surface, v, to_light, sample);
        sample->shadow_rays.rays[v] = ray_of(origin, to_light);
        sample->shadow_rays.limit[v] = real_of(INFINITE);
    }
}

/** Aims at a point. See #light_sample_packet. @param offset Where the rays start. */
static void sample_point_light(const Light *light, const RayOffset *offset,
                               const SurfaceHit *surface, LightSample *sample) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit *hit = &surface->hits[v];
        Vec3 to_light = vec3_subtract(light->position, hit->point);
        Vec3 origin = ray_offset_origin(offset, hit, to_light);
        light_sample_set(surface, v, to_light, sample);
        // The ray ends at the lamp itself: its parameter runs from 0 to 1.
        sample->shadow_rays.rays[v] = ray_of(origin, vec3_subtract(light->position, origin));
        sample->shadow_rays.limit[v] = real_of(1);
    }
}

/** Lets the rays to a ball's centre end at the ball: what stands in it is not in the way. */
static void clip_to_sphere(const Light *light, LightSample *sample) {
    for (int v = 0; v < PACKET_VECTORS; v++) {
        real t_end = 1 - light->radius / real_sqrt(sample->distance_squared[v]);
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

/**
 * @return Points of the unit disc, as evenly spread as those of the square are: squares around the
 *         middle become circles (Shirley, Chiu, *A Low Distortion Map Between Disk and Square*,
 *         1997).
 * @param a  Across, -1 to 1.
 * @param b  Up, -1 to 1.
 */
INLINE DiscPoint concentric_disc_map(real a, real b) {
    mask is_wide = real_abs(a) > real_abs(b);
    real radius = real_select(is_wide, a, b), other = real_select(is_wide, b, a);
    real ratio = real_select(radius == 0, real_of(0), other / radius);
    real sine = sine_of_eighth_turn(ratio), along = radius * real_sqrt(1 - sine * sine);
    real across = radius * sine;
    return (DiscPoint){real_select(is_wide, along, across), real_select(is_wide, across, along)};
}

/** @return -1 to 1, exact in every number type. */
INLINE scalar signed_unit(uint32_t bits) {
    return (scalar)((int32_t)(bits >> 8) - (1 << 23)) * (scalar)0x1p-23;
}

/**
 * @return The points of a ball's disc that the rays of a packet ask for: for all pixels the same
 *         point of the sequence, moved in each by its own number (exclusive or keeps the evenness
 *         of Sobol's points).
 * @param v  Which vector of rays.
 */
static DiscPoint disc_sample(const SampleContext *context, size_t light_index, int v) {
    uint32_t seed = hash_combine_u32((uint32_t)light_index, context->bounce);
    SobolPoint point = sobol_point(context->sample, seed);
    real a = {0}, b = {0};
    for (int i = 0; i < LANES; i++) {
        uint32_t pixel = hash_u32(context->pixel_ids[v * LANES + i] ^ seed);
        real_set_lane(&a, i, signed_unit(point.x ^ pixel));
        real_set_lane(&b, i, signed_unit(point.y ^ hash_u32(pixel)));
    }
    return concentric_disc_map(a, b);
}

/**
 * @return Directions within the cone that a ball fills.
 * @param axis    Unit vectors to the ball's centre.
 * @param one_minus_cos  1 - cos a of the cone.
 * @param disc    Where in the cone.
 */
INLINE Vec3 cone_sample(Vec3 axis, real one_minus_cos, DiscPoint disc) {
    // Two vectors at right angles (Duff and others, *Building an Orthonormal Basis, Revisited*,
    // 2017).
    real sign = real_select(axis.z < 0, real_of(-1), real_of(1));
    real a = -1 / (sign + axis.z), b = axis.x * axis.y * a;
    Vec3 across = {1 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
    Vec3 up = {b, sign + axis.y * axis.y * a, -axis.y};
    // The share of the disc within a point is the share of the cone within its direction.
    real fraction = disc.x * disc.x + disc.y * disc.y;
    real sin_theta = real_sqrt(one_minus_cos * (2 - fraction * one_minus_cos));
    Vec3 offset =
        vec3_add(vec3_scale(across, disc.x * sin_theta), vec3_scale(up, disc.y * sin_theta));
    return vec3_normalize(vec3_add(offset, vec3_scale(axis, 1 - fraction * one_minus_cos)));
}

/**
 * Aims at a ball, each ray at another point of it. See #light_sample_packet.
 * @param offset  Where the rays start.
 * @param[out] sample  What the lamp would give.
 */
static void sample_sphere_light(const Light *light, size_t light_index, const RayOffset *offset,
                                const SurfaceHit *surface, LightSample *sample) {
    real radius_squared = real_of(light->radius * light->radius);
    for (int v = 0; v < PACKET_VECTORS; v++) {
        const Hit *hit = &surface->hits[v];
        sample->shadow_rays.active[v] = surface->needs_light[v];
        if (!any(surface->needs_light[v])) {
            continue;
        }
        Vec3 to_light = vec3_subtract(light->position, hit->point);
        real distance_squared =
            real_max(vec3_dot(to_light, to_light), real_of(MIN_DISTANCE_SQUARED));
        real distance = real_sqrt(distance_squared);
        real sine_squared = real_min(radius_squared / distance_squared, real_of(1));
        real cosine = real_sqrt(1 - sine_squared), one_minus_cos = sine_squared / (1 + cosine);
        DiscPoint disc = disc_sample(&surface->packet->context, light_index, v);
        Vec3 direction = cone_sample(vec3_scale(to_light, 1 / distance), one_minus_cos, disc);
        // The ray ends where it meets the ball: half a chord before its point nearest the centre.
        real along = vec3_dot(to_light, direction);
        real half_chord_squared = radius_squared - (distance_squared - along * along);
        real end = along - real_sqrt(real_max(half_chord_squared, real_of(0)));
        sample->shadow_rays.rays[v] = ray_of(ray_offset_origin(offset, hit, direction), direction);
        sample->shadow_rays.limit[v] = real_max(end, real_of(0));
        sample->cosine[v] = vec3_dot(surface->n_front[v], direction);
        sample->shadow_rays.active[v] &= sample->cosine[v] > 0;
        sample->distance_squared[v] = distance_squared;
        sample->weight[v] = 2 / (1 + cosine);
    }
}

void light_sample_packet(const Light *light, size_t light_index, const RayOffset *offset,
                         const SurfaceHit *surface, LightSample *sample) {
    sample->shadow_rays.wants_points = false;
    if (light->is_soft) {
        sample_sphere_light(light, light_index, offset, surface, sample);
        return;
    }
    if (light->is_sun) {
        sample_sun(light, offset, surface, sample);
        return;
    }
    sample_point_light(light, offset, surface, sample);
    if (light->radius > 0) {
        clip_to_sphere(light, sample);
    }
}
