/**
 * @file
 * @brief `sun`: parallel light from an infinite distance.
 */
#include "scene/lights/light_rows.h"

/** Fields of `sun`. */
static const Parameter sun_parameters[] = {{.name = "direction",
                                            .type = PARAMETER_DIRECTION,
                                            .offset = offsetof(SceneLight, direction),
                                            .minimum = -LENGTH_MAXIMUM,
                                            .maximum = LENGTH_MAXIMUM,
                                            .unit = N_("any length"),
                                            .help = N_("the way that its light travels")},
                                           LIGHT_COLOR_ROW,
                                           LIGHT_INTENSITY_ROW,
                                           {0}};

/** A white sun, high behind the right side of the default camera. */
static const SceneLight sun_defaults = {
    .color = {1, 1, 1}, .intensity = 1, .direction = {-1, -2, -1}};

/** The scene language's `sun`. */
static const Keyword sun_keyword = {.name = "sun",
                                    .help = "parallel light from far away",
                                    .parameters = sun_parameters,
                                    .size = sizeof(SceneLight),
                                    .defaults = &sun_defaults};

/** Rotates a sun. See #SceneLightClass.move. */
static void sun_move(SceneLight *sun, Vec3d offset, double distance) {
    Vec3d to_sun = vec3d_scale(vec3d_normalize(sun->direction), -distance);
    Vec3d direction = vec3d_scale(vec3d_add(to_sun, offset), -1);
    if (vec3d_length(direction) > 0) {
        sun->direction = vec3d_normalize(direction);
    }
}

/** Copies the direction. See #SceneLightClass.copy_position. */
static void sun_copy_position(SceneLight *sun, const SceneLight *source) {
    sun->direction = source->direction;
}

/** @return The vector to a sun. See #SceneLightClass.offset_from. */
static Vec3d sun_offset_from(const SceneLight *sun, Vec3d point) {
    (void)point;
    return vec3d_scale(sun->direction, -1);
}

/** The class of `sun`. */
extern const SceneLightClass scene_sun_class;

const SceneLightClass scene_sun_class = {.keyword = &sun_keyword,
                                         .move = sun_move,
                                         .copy_position = sun_copy_position,
                                         .offset_from = sun_offset_from};
