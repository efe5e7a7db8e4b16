/**
 * @file
 * @brief Suns: parallel light from infinitely far away.
 */
#include "trace/lights/light.h"

/** A sun's own struct. */
typedef struct LIGHT_OWN Sun {
    Vec3 to_sun; /**< The unit direction towards it. */
} Sun;

/** Samples a sun. See #LightSampler. */
static void sun_sample(const Light *light, size_t light_index, const RayOffset *offset,
                       const SurfaceHit *surface, LightSample *sample) {
    (void)light_index;
    const Sun *sun = light_own(light);
    for (int v = 0; v < packet_vector_count(surface->packet); v++) {
        Vec3 to_light = sun->to_sun,
             origin = ray_offset_origin(offset, &surface->hits[v], to_light);
        light_sample_set(surface, v, to_light, sample);
        sample->shadow_rays.rays[v] = ray_of(origin, to_light);
        sample->shadow_rays.limit[v] = real_of(INFINITE);
    }
}

/** Fills a sun. See #LightClass.init. */
static void sun_init(Light *self, const SceneLight *said, int samples) {
    (void)samples;
    Vec3d direction = vec3d_normalize(vec3d_scale_exponent(said->direction));
    *(Sun *)self->own = (Sun){vec3_of(vec3d_scale(direction, -1))};
    self->sample = sun_sample;
    self->is_inverse_square = self->is_inverse_linear = false;
    self->is_at_infinity = true;
}

/** The class of `sun`. */
extern const LightClass sun_class;

const LightClass sun_class = {.init = sun_init};
