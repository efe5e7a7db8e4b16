/**
 * @file
 * @brief The sky.
 */
#include "dioptre/scene.h"

/** Rows of #sky_parameters by place. */
enum { ROW_COLOR, ROW_HORIZON, ROW_ZENITH };

/** Fields of `sky`. */
static const Parameter sky_parameters[] = {[ROW_COLOR] = {.name = "color",
                                                          .type = PARAMETER_COLOR,
                                                          .offset = offsetof(Sky, color),
                                                          .minimum = 0,
                                                          .maximum = INTENSITY_MAXIMUM,
                                                          .unit = "linear light",
                                                          .help = "one colour all around"},
                                           [ROW_HORIZON] = {.name = "horizon",
                                                            .type = PARAMETER_COLOR,
                                                            .offset = offsetof(Sky, horizon),
                                                            .minimum = 0,
                                                            .maximum = INTENSITY_MAXIMUM,
                                                            .unit = "linear light",
                                                            .help = "at the horizon and below"},
                                           [ROW_ZENITH] = {.name = "zenith",
                                                           .type = PARAMETER_COLOR,
                                                           .offset = offsetof(Sky, zenith),
                                                           .minimum = 0,
                                                           .maximum = INTENSITY_MAXIMUM,
                                                           .unit = "linear light",
                                                           .help = "straight up"},
                                           {0}};

/** A black sky. */
static const Sky sky_defaults = {0};

/**
 * Makes one colour a gradient from itself to itself. See #Keyword.finish.
 * @param[in,out] values  A #Sky.
 * @param given           Which rows were given.
 * @param[out] error      What is wrong.
 * @return false where both kinds of sky are asked for.
 */
static bool sky_finish(void *values, uint64_t given, Error *error) {
    Sky *sky = values;
    bool is_gradient = (given >> ROW_HORIZON | given >> ROW_ZENITH) & 1;
    if (is_gradient && given >> ROW_COLOR & 1) {
        return error_set(error, STATUS_SCENE, "sky takes color, or horizon and zenith, not both");
    }
    if (!is_gradient) {
        sky->horizon = sky->zenith = sky->color;
    }
    return true;
}

const Keyword sky_keyword = {.name = "sky",
                             .help = "what is behind everything",
                             .parameters = sky_parameters,
                             .size = sizeof(Sky),
                             .defaults = &sky_defaults,
                             .finish = sky_finish};
