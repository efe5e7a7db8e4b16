/**
 * @file
 * @brief `light`: a point light, or a spherical light with a radius.
 */
#include "scene/lights/light_rows.h"

const char *const light_falloff_words[] = {"none", "inverse_square", "inverse_linear", NULL};

/** Fields of `light`. */
static const Parameter point_light_parameters[] = {
    LIGHT_LENGTH_ROW("position", PARAMETER_POINT, offsetof(SceneLight, position), -LENGTH_MAXIMUM,
                     N_("where the lamp is")),
    LIGHT_COLOR_ROW,
    LIGHT_INTENSITY_ROW,
    LIGHT_FALLOFF_ROW,
    LIGHT_FALLOFF_CONSTANT_ROW,
    LIGHT_LENGTH_ROW("radius", PARAMETER_NUMBER, offsetof(SceneLight, radius), 0,
                     N_("above 0: seen as a glowing ball, with soft shadows")),
    {0}};

/** A white light just under a ceiling at height 2. */
static const SceneLight point_light_defaults = {.color = {1, 1, 1},
                                                .intensity = 1,
                                                .position = {0, 1.9, 0},
                                                .falloff = FALLOFF_NONE,
                                                .falloff_constant = LIGHT_FALLOFF_CONSTANT};

/**
 * Rejects spheres too small for the engines' number types. See #Keyword.finish.
 * @return Whether it is valid.
 */
static bool point_light_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const SceneLight *light = values;
    if (light->radius > 0 && light->radius < LENGTH_MINIMUM) {
        return error_set(error, STATUS_SCENE, "radius must be 0 or at least %g, not %g",
                         LENGTH_MINIMUM, light->radius);
    }
    return true;
}

/** @return The position. See #SceneLightClass.center. */
static Vec3d point_light_center(const SceneLight *light) {
    return light->position;
}

const Keyword scene_light_keyword = {.name = "light",
                                     .help = "a lamp: a point, or a glowing ball",
                                     .parameters = point_light_parameters,
                                     .size = sizeof(SceneLight),
                                     .defaults = &point_light_defaults,
                                     .finish = point_light_finish};

/** @return The size of a spherical light, which shines as from its centre. See
 *  #SceneLightClass.size. */
static SceneLightSize point_light_size(const SceneLight *light) {
    return (SceneLightSize){0, M_PI * light->radius * light->radius};
}

/** The class of `light`. */
extern const SceneLightClass scene_point_light_class;

const SceneLightClass scene_point_light_class = {
    .keyword = &scene_light_keyword, .center = point_light_center, .size = point_light_size};
