/**
 * @file
 * @brief Lights of any class, and the points of the square that their samples start from.
 */
#include "trace/lights/light.h"

#include "trace/math/sobol.h"

/** No light gives more than this at any point, so that sums stay finite in float. */
#define MAX_RADIANCE ((scalar)1e30)

/** Declares a class of the registry. */
#define DECLARE_CLASS(name) extern const LightClass name##_class;
SCENE_LIGHT_CLASSES(DECLARE_CLASS)

/** The address of a class of the registry. */
#define CLASS_ADDRESS(name) &name##_class,
/** The classes, in the order of #scene_light_classes. */
static const LightClass *const light_classes[] = {SCENE_LIGHT_CLASSES(CLASS_ADDRESS)};

const LightClass *light_class_of(const SceneLight *light) {
    return light_classes[light->class_index];
}

void light_set_min_distance_squared(Light *light, scalar squared) {
    scalar max_channel = real_lane(rgb_max(light->intensity), 0);
    scalar min_for_finite = (max_channel > 1 ? max_channel : 1) / MAX_RADIANCE;
    squared = squared > MIN_DISTANCE_SQUARED ? squared : MIN_DISTANCE_SQUARED;
    light->min_distance_squared = squared > min_for_finite ? squared : min_for_finite;
}

Light light_of(const SceneLight *said, int samples) {
    scalar intensity = (scalar)said->intensity;
    Rgbs color = rgbs_of(said->color);
    Rgbs bright = {color.red * intensity, color.green * intensity, color.blue * intensity};
    Light light = {.class = light_class_of(said),
                   .intensity = rgb_splat(bright),
                   .radiance = rgb_splat(bright),
                   .is_inverse_square = said->falloff == FALLOFF_INVERSE_SQUARE,
                   .is_inverse_linear = said->falloff == FALLOFF_INVERSE_LINEAR,
                   .falloff_constant = (scalar)said->falloff_constant};
    light_set_min_distance_squared(&light, 0);
    light.class->init(&light, said, samples);
    return light;
}

/** @return -1 to 1, exact in every number type. */
INLINE scalar signed_unit(uint32_t bits) {
    return (scalar)((int32_t)(bits >> 8) - (1 << 23)) * (scalar)0x1p-23;
}

SquareSample light_square_sample(const SampleContext *context, size_t light_index, int v) {
    uint32_t seed = hash_combine_u32((uint32_t)light_index, context->bounce);
    SobolPoint point = sobol_point(context->sample, seed);
    SquareSample square = {real_of(0), real_of(0)};
    for (int i = 0; i < LANES; i++) {
        uint32_t pixel = hash_u32(context->pixel_ids[v * LANES + i] ^ seed);
        real_set_lane(&square.a, i, signed_unit(point.x ^ pixel));
        real_set_lane(&square.b, i, signed_unit(point.y ^ hash_u32(pixel)));
    }
    return square;
}
