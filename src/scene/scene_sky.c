/**
 * @file
 * @brief The sky.
 */
#include "dioptre/scene.h"

/** Indices of the rows of #scene_sky_parameters. */
enum { ROW_COLOR, ROW_HORIZON, ROW_ZENITH, ROW_IMAGE, ROW_ROTATE };

/** Largest rotation, degrees, as for shapes. */
#define SKY_ROTATION_MAXIMUM 36000.0

/** Fields of `sky`. */
static const Parameter scene_sky_parameters[] = {
    [ROW_COLOR] = {.name = "color",
                   .type = PARAMETER_COLOR,
                   .offset = offsetof(SceneSky, color),
                   .minimum = 0,
                   .maximum = INTENSITY_MAXIMUM,
                   .unit = "linear light",
                   .help = "one colour all around"},
    [ROW_HORIZON] = {.name = "horizon",
                     .type = PARAMETER_COLOR,
                     .offset = offsetof(SceneSky, horizon),
                     .minimum = 0,
                     .maximum = INTENSITY_MAXIMUM,
                     .unit = "linear light",
                     .help = "at the horizon and below"},
    [ROW_ZENITH] = {.name = "zenith",
                    .type = PARAMETER_COLOR,
                    .offset = offsetof(SceneSky, zenith),
                    .minimum = 0,
                    .maximum = INTENSITY_MAXIMUM,
                    .unit = "linear light",
                    .help = "straight up"},
    [ROW_IMAGE] = {.name = "image",
                   .type = PARAMETER_TEXTURE,
                   .offset = offsetof(SceneSky, texture_id),
                   .unit = "file",
                   .help = "a panorama all around"},
    [ROW_ROTATE] = {.name = "rotate",
                    .type = PARAMETER_NUMBER,
                    .offset = offsetof(SceneSky, rotate),
                    .minimum = -SKY_ROTATION_MAXIMUM,
                    .maximum = SKY_ROTATION_MAXIMUM,
                    .unit = "degrees",
                    .help = "turns the panorama about y"},
    {0}};

/** A black sky. */
static const SceneSky scene_sky_defaults = {0};

/**
 * @return Whether the scene gives a row.
 * @param given  Bits of the given rows.
 * @param row    Index of the row.
 */
static bool is_given(uint64_t given, int row) {
    return given >> row & 1;
}

/**
 * Converts a uniform colour to a gradient with equal ends. See #Keyword.finish.
 * @param values  The #SceneSky.
 * @param given   Bits of the given rows.
 * @param error   What is wrong.
 * @return false if the fields are inconsistent.
 */
static bool scene_sky_finish(void *values, uint64_t given, Error *error) {
    SceneSky *sky = values;
    bool is_gradient = is_given(given, ROW_HORIZON) || is_given(given, ROW_ZENITH);
    if (is_given(given, ROW_IMAGE) && (is_gradient || is_given(given, ROW_COLOR))) {
        return error_set(error, STATUS_SCENE, "sky takes image, or colours, not both");
    }
    if (is_gradient && is_given(given, ROW_COLOR)) {
        return error_set(error, STATUS_SCENE, "sky takes color, or horizon and zenith, not both");
    }
    if (is_given(given, ROW_ROTATE) && !is_given(given, ROW_IMAGE)) {
        return error_set(error, STATUS_SCENE, "sky takes rotate only with image");
    }
    if (!is_gradient) {
        sky->horizon = sky->zenith = sky->color;
    }
    return true;
}

const Keyword scene_sky_keyword = {.name = "sky",
                                   .help = "what is behind everything",
                                   .parameters = scene_sky_parameters,
                                   .size = sizeof(SceneSky),
                                   .defaults = &scene_sky_defaults,
                                   .finish = scene_sky_finish};
