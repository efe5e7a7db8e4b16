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
        .name = "color", .type = PARAMETER_COLOR, .offset = offsetof(Light, color), .minimum = 0,  \
        .maximum = INTENSITY_MAXIMUM, .unit = "linear light", .help = "its colour"                 \
    }

/** The row `intensity` of both kinds. */
#define INTENSITY_ROW                                                                              \
    {                                                                                              \
        .name = "intensity", .type = PARAMETER_NUMBER, .offset = offsetof(Light, intensity),       \
        .minimum = 0, .maximum = INTENSITY_MAXIMUM, .unit = "factor",                              \
        .help = "multiplies the colour"                                                            \
    }

/** Fields of `light`. */
static const Parameter light_parameters[] = {
    {.name = "position",
     .type = PARAMETER_POINT,
     .offset = offsetof(Light, position),
     .minimum = -LENGTH_MAXIMUM,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "where the lamp is"},
    COLOR_ROW,
    INTENSITY_ROW,
    {.name = "falloff",
     .type = PARAMETER_WORD,
     .offset = offsetof(Light, falloff),
     .words = falloff_words,
     .unit = "word",
     .help = "how it weakens with the distance"},
    {.name = "radius",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(Light, radius),
     .minimum = 0,
     .maximum = LENGTH_MAXIMUM,
     .unit = "scene units",
     .help = "above 0: seen as a glowing ball, with soft shadows"},
    {0}};

/** Fields of `sun`. */
static const Parameter sun_parameters[] = {{.name = "direction",
                                            .type = PARAMETER_DIRECTION,
                                            .offset = offsetof(Light, direction),
                                            .minimum = -LENGTH_MAXIMUM,
                                            .maximum = LENGTH_MAXIMUM,
                                            .unit = "any length",
                                            .help = "the way that its light travels"},
                                           COLOR_ROW,
                                           INTENSITY_ROW,
                                           {0}};

/** A white lamp just under a ceiling 2 units high. */
static const Light light_defaults = {.kind = LIGHT_POINT,
                                     .color = {1, 1, 1},
                                     .intensity = 1,
                                     .position = {0, 1.9, 0},
                                     .falloff = FALLOFF_NONE};

/** A white sun, high behind the viewer's right shoulder. */
static const Light sun_defaults = {
    .kind = LIGHT_SUN, .color = {1, 1, 1}, .intensity = 1, .direction = {-1, -2, -1}};

/**
 * Sees that a ball is not too small to be met. See #Keyword.finish.
 * @param[in,out] values  A #Light.
 * @param given           Not used.
 * @param[out] error      What is wrong.
 * @return false where it is.
 */
static bool light_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const Light *light = values;
    if (light->radius > 0 && light->radius < LENGTH_MINIMUM) {
        return error_set(error, STATUS_SCENE, "radius must be 0 or at least %g, not %g",
                         LENGTH_MINIMUM, light->radius);
    }
    return true;
}

const Keyword light_keyword = {.name = "light",
                               .help = "a lamp: a point, or a glowing ball",
                               .parameters = light_parameters,
                               .size = sizeof(Light),
                               .defaults = &light_defaults,
                               .finish = light_finish};

const Keyword sun_keyword = {.name = "sun",
                             .help = "parallel light from far away",
                             .parameters = sun_parameters,
                             .size = sizeof(Light),
                             .defaults = &sun_defaults};

const Keyword *light_keyword_of(const Light *light) {
    return light->kind == LIGHT_SUN ? &sun_keyword : &light_keyword;
}

bool light_is_ball(const Light *light) {
    return light->kind == LIGHT_POINT && light->radius > 0;
}

/** Turns a sun. See #light_move. @param[in,out] sun It. @param way How far. @param distance How far
 *  away it is taken to be. */
static void sun_turn(Light *sun, Vector3 way, double distance) {
    Vector3 to_sun = vector3_scale(vector3_normalize(sun->direction), -distance);
    Vector3 travels = vector3_scale(vector3_add(to_sun, way), -1);
    if (vector3_length(travels) > 0) {
        sun->direction = vector3_normalize(travels);
    }
}

void light_move(Light *light, Vector3 way, double distance) {
    if (light->kind == LIGHT_SUN) {
        sun_turn(light, way, distance);
    } else {
        light->position = vector3_add(light->position, way);
    }
}
