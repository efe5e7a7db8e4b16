/**
 * @file
 * @brief Materials.
 */
#include "dioptre/material.h"

/**
 * Largest weight of a term. Not 1: a teacher may overdo a highlight to show it.
 */
#define WEIGHT_MAXIMUM 1000.0
/** Sharpest highlight: at this exponent it is smaller than a pixel, and float has run out. */
#define SHININESS_MAXIMUM 1e6

/** Fields of `material`. */
static const Parameter material_parameters[] = {{.name = "color",
                                                 .type = PARAMETER_COLOR,
                                                 .offset = offsetof(Material, color),
                                                 .minimum = 0,
                                                 .maximum = 1,
                                                 .unit = "share",
                                                 .help = "light that a matt surface sends back"},
                                                {.name = "texture",
                                                 .type = PARAMETER_TEXTURE,
                                                 .offset = offsetof(Material, texture),
                                                 .unit = "file",
                                                 .help = "a picture that multiplies color"},
                                                {.name = "ambient",
                                                 .type = PARAMETER_NUMBER,
                                                 .offset = offsetof(Material, ambient),
                                                 .minimum = 0,
                                                 .maximum = WEIGHT_MAXIMUM,
                                                 .unit = "weight",
                                                 .help = "of the light from everywhere"},
                                                {.name = "diffuse",
                                                 .type = PARAMETER_NUMBER,
                                                 .offset = offsetof(Material, diffuse),
                                                 .minimum = 0,
                                                 .maximum = WEIGHT_MAXIMUM,
                                                 .unit = "weight",
                                                 .help = "of each light's matt shine"},
                                                {.name = "specular",
                                                 .type = PARAMETER_NUMBER,
                                                 .offset = offsetof(Material, specular),
                                                 .minimum = 0,
                                                 .maximum = WEIGHT_MAXIMUM,
                                                 .unit = "weight",
                                                 .help = "of each light's highlight"},
                                                {.name = "shininess",
                                                 .type = PARAMETER_NUMBER,
                                                 .offset = offsetof(Material, shininess),
                                                 .minimum = 0,
                                                 .maximum = SHININESS_MAXIMUM,
                                                 .unit = "exponent",
                                                 .help = "the larger, the smaller the highlight"},
                                                {.name = "reflectivity",
                                                 .type = PARAMETER_COLOR,
                                                 .offset = offsetof(Material, reflectivity),
                                                 .minimum = 0,
                                                 .maximum = 1,
                                                 .unit = "share",
                                                 .help = "of light that is mirrored"},
                                                {.name = "emission",
                                                 .type = PARAMETER_COLOR,
                                                 .offset = offsetof(Material, emission),
                                                 .minimum = 0,
                                                 .maximum = INTENSITY_MAXIMUM,
                                                 .unit = "linear light",
                                                 .help = "light of its own"},
                                                {0}};

/** Matt white. */
static const Material material_defaults = {
    .color = {1, 1, 1}, .ambient = 1, .diffuse = 1, .shininess = 50};

const Keyword material_keyword = {.name = "material",
                                  .help = "what a surface does with light",
                                  .parameters = material_parameters,
                                  .size = sizeof(Material),
                                  .defaults = &material_defaults};

bool material_is_mirror(const Material *material) {
    const Color *share = &material->reflectivity;
    return share->red > 0 || share->green > 0 || share->blue > 0;
}
