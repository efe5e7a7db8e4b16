/**
 * @file
 * @brief Lamps and suns.
 */
#include "dioptre/light.h"

/** Words of `falloff`, in the order of #Falloff. */
static const char *const falloff_words[] = {"none", "inverse_square", NULL};

/** The row `color` of both kinds. */
#define COLOR_ROW                                                                                  \
    {                                                                                              \
        .name = "color", .type = PARAMETER_COLOR, .offset = offsetof(SceneLight, color),           \
        .minimum = 0, .maximum = INTENSITY_MAXIMUM, .unit = "linear light", .help = "its colour"   \
    }

/** The row `intensity` of both kinds. */
#define INTENSITY_ROW                                                                              \
    {                                                                                              \
        .name = "intensity", .type = PARAMETER_NUMBER, .offset = offsetof(SceneLight, intensity),  \
        .minimum = 0, .maximum = INTENSITY_MAXIMUM, .unit = "factor",                              \
        .help = "multiplies the colour"                                                            \
    }

/** Fields of `light`. */
static const Parameter scene_light_parameters[] = {
    {.name = "position",
     .type = PARAMETER_POINT,
     .offset = offsetof(SceneLight, position),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "where the lamp is"},
    COLOR_ROW,
    INTENSITY_ROW,
    {.name = "falloff",
     .type = PARAMETER_CHOICE,
     .offset = offsetof(SceneLight, falloff),
     .choices = falloff_words,
     .unit = "word",
     .help = "how it weakens with the distance"},
    {.name = "radius",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(SceneLight, radius),
     .minimum = 0,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "above 0: seen as a glowing ball, with soft shadows"},
    {0}};

/** Fields of `sun`. */
static const Parameter scene_sun_parameters[] = {{.name = "direction",
                                                  .type = PARAMETER_DIRECTION,
                                                  .offset = offsetof(SceneLight, direction),
                                                  .minimum = -LENGTH_MAXIMUM,
                                                  .maximum = LENGTH_MAXIMUM,
                                                  .unit = "any length",
                                                  .help = "the way that its light travels"},
                                                 COLOR_ROW,
                                                 INTENSITY_ROW,
                                                 {0}};

/** A white lamp just under a ceiling 2 units high. */
static const SceneLight scene_light_defaults = {.kind = SCENE_LIGHT_POINT,
                                                .color = {1, 1, 1},
                                                .intensity = 1,
                                                .position = {0, 1.9, 0},
                                                .falloff = FALLOFF_NONE};

/** A white sun, high behind the viewer's right shoulder. */
static const SceneLight scene_sun_defaults = {
    .kind = SCENE_LIGHT_SUN, .color = {1, 1, 1}, .intensity = 1, .direction = {-1, -2, -1}};

/** Sees that a ball is not too small to be met. See #Keyword.finish. @return false where it is. */
static bool scene_light_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const SceneLight *light = values;
    if (light->radius > 0 && light->radius < LENGTH_MINIMUM) {
        return error_set(error, STATUS_SCENE, "radius must be 0 or at least %g, not %g",
                         LENGTH_MINIMUM, light->radius);
    }
    return true;
}

const Keyword scene_light_keyword = {.name = "light",
                                     .help = "a lamp: a point, or a glowing ball",
                                     .parameters = scene_light_parameters,
                                     .size = sizeof(SceneLight),
                                     .defaults = &scene_light_defaults,
                                     .finish = scene_light_finish};

const Keyword scene_sun_keyword = {.name = "sun",
                                   .help = "parallel light from far away",
                                   .parameters = scene_sun_parameters,
                                   .size = sizeof(SceneLight),
                                   .defaults = &scene_sun_defaults};

const Keyword *scene_light_keyword_for(const SceneLight *light) {
    return light->kind == SCENE_LIGHT_SUN ? &scene_sun_keyword : &scene_light_keyword;
}

bool scene_light_is_spherical(const SceneLight *light) {
    return light->kind == SCENE_LIGHT_POINT && light->radius > 0;
}

/** Turns a sun. See #scene_light_move. @param distance How far away it is taken to be. */
static void scene_sun_move(SceneLight *sun, Vec3d offset, double distance) {
    Vec3d to_sun = vec3d_scale(vec3d_normalize(sun->direction), -distance);
    Vec3d direction = vec3d_scale(vec3d_add(to_sun, offset), -1);
    if (vec3d_length(direction) > 0) {
        sun->direction = vec3d_normalize(direction);
    }
}

void scene_light_move(SceneLight *light, Vec3d offset, double distance) {
    if (light->kind == SCENE_LIGHT_SUN) {
        scene_sun_move(light, offset, distance);
    } else {
        light->position = vec3d_add(light->position, offset);
    }
}
