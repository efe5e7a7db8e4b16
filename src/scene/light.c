/**
 * @file
 * @brief Point lights.
 */
#include "dioptre/light.h"

/** Words of `falloff`, in the order of #Falloff. */
static const char *const falloff_words[] = {"none", "inverse_square", NULL};

/** Fields of `light`. */
static const Parameter light_parameters[] = {{.name = "position",
                                              .type = PARAMETER_VECTOR,
                                              .offset = offsetof(Light, position),
                                              .minimum = -LENGTH_MAXIMUM,
                                              .maximum = LENGTH_MAXIMUM,
                                              .unit = "scene units",
                                              .help = "where the lamp is"},
                                             {.name = "color",
                                              .type = PARAMETER_COLOR,
                                              .offset = offsetof(Light, color),
                                              .minimum = 0,
                                              .maximum = INTENSITY_MAXIMUM,
                                              .unit = "linear light",
                                              .help = "its colour"},
                                             {.name = "intensity",
                                              .type = PARAMETER_NUMBER,
                                              .offset = offsetof(Light, intensity),
                                              .minimum = 0,
                                              .maximum = INTENSITY_MAXIMUM,
                                              .unit = "factor",
                                              .help = "multiplies the colour"},
                                             {.name = "falloff",
                                              .type = PARAMETER_WORD,
                                              .offset = offsetof(Light, falloff),
                                              .words = falloff_words,
                                              .unit = "word",
                                              .help = "how it weakens with the distance"},
                                             {0}};

/** A white lamp just under a ceiling 2 units high. */
static const Light light_defaults = {
    .position = {0, 1.9, 0}, .color = {1, 1, 1}, .intensity = 1, .falloff = FALLOFF_NONE};

const Keyword light_keyword = {.name = "light",
                               .help = "a lamp without size",
                               .parameters = light_parameters,
                               .size = sizeof(Light),
                               .defaults = &light_defaults};
