/**
 * @file
 * @brief Rows of parameter tables that several classes of lights share.
 */
#ifndef DIOPTRE_SCENE_LIGHT_ROWS_H
#define DIOPTRE_SCENE_LIGHT_ROWS_H

#include "base/language.h"
#include "dioptre/scene.h"

/** The row `color`. */
#define LIGHT_COLOR_ROW                                                                            \
    {                                                                                              \
        .name = "color", .type = PARAMETER_COLOR, .offset = offsetof(SceneLight, color),           \
        .minimum = 0, .maximum = INTENSITY_MAXIMUM, .unit = N_("linear light"),                    \
        .help = N_("its colour")                                                                   \
    }

/** The row `intensity`. */
#define LIGHT_INTENSITY_ROW                                                                        \
    {                                                                                              \
        .name = "intensity", .type = PARAMETER_NUMBER, .offset = offsetof(SceneLight, intensity),  \
        .minimum = 0, .maximum = INTENSITY_MAXIMUM, .unit = N_("factor"),                          \
        .help = N_("multiplies the colour")                                                        \
    }

/** The words of `falloff`, in the order of #Falloff. */
extern const char *const light_falloff_words[];

/** The row `falloff`. */
#define LIGHT_FALLOFF_ROW                                                                          \
    {                                                                                              \
        .name = "falloff", .type = PARAMETER_CHOICE, .offset = offsetof(SceneLight, falloff),      \
        .choices = light_falloff_words, .unit = N_("word"),                                        \
        .help = N_("how it weakens with the distance")                                             \
    }

/** The row `falloff_constant`. */
#define LIGHT_FALLOFF_CONSTANT_ROW                                                                 \
    LIGHT_LENGTH_ROW("falloff_constant", PARAMETER_NUMBER, offsetof(SceneLight, falloff_constant), \
                     0, N_("c, where the falloff is inverse_linear: 1 / (c + distance)"))

/** Default of `falloff_constant`, scene units: that of report D, whose lamps give 5 / (2 + d). */
#define LIGHT_FALLOFF_CONSTANT 2

/** A row for a length or a position in scene units. */
#define LIGHT_LENGTH_ROW(name_, type_, offset_, minimum_, help_)                                   \
    {                                                                                              \
        .name = name_, .type = type_, .offset = offset_, .minimum = minimum_,                      \
        .maximum = LENGTH_MAXIMUM, .unit = N_("scene units"), .help = help_                        \
    }

#endif
