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
/** Most that reflectivity and transparency may be together: 1, and what writing 0.9 and 0.1 in
 *  binary adds. */
#define SHARES_MAXIMUM (1 + 1e-9)
/** Least index of refraction; things optically thinner than air exist for X-rays only, and in
 * class.
 */
#define IOR_MINIMUM 0.01
/** Largest index of refraction: far above diamond's 2.4. */
#define IOR_MAXIMUM 100.0

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
                                                {.name = "transparency",
                                                 .type = PARAMETER_COLOR,
                                                 .offset = offsetof(Material, transparency),
                                                 .minimum = 0,
                                                 .maximum = 1,
                                                 .unit = "share",
                                                 .help = "of light that is let through"},
                                                {.name = "ior",
                                                 .type = PARAMETER_NUMBER,
                                                 .offset = offsetof(Material, ior),
                                                 .minimum = IOR_MINIMUM,
                                                 .maximum = IOR_MAXIMUM,
                                                 .unit = "times that of air",
                                                 .help = "index of refraction inside"},
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
    .color = {1, 1, 1}, .ambient = 1, .diffuse = 1, .shininess = 50, .ior = 1.5};

/**
 * Refuses surfaces that send back more light than they get. See #Keyword.finish.
 * @param[in,out] values  A #Material.
 * @param given           Not looked at.
 * @param[out] error      What is wrong.
 * @return Whether reflectivity and transparency are at most 1 together.
 */
static bool material_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const Material *m = values;
    const Color *mirror = &m->reflectivity, *through = &m->transparency;
    double most = fmax(mirror->red + through->red,
                       fmax(mirror->green + through->green, mirror->blue + through->blue));
    return most <= SHARES_MAXIMUM ||
           error_set(error, STATUS_SCENE,
                     "reflectivity and transparency are %g together; they must be at most 1 in "
                     "red, green and blue",
                     most);
}

const Keyword material_keyword = {.name = "material",
                                  .help = "what a surface does with light",
                                  .parameters = material_parameters,
                                  .size = sizeof(Material),
                                  .defaults = &material_defaults,
                                  .finish = material_finish};

/** @return Whether there is anything of any primary. @param share Shares. */
static bool color_is_any(const Color *share) {
    return share->red > 0 || share->green > 0 || share->blue > 0;
}

bool material_is_mirror(const Material *material) {
    return color_is_any(&material->reflectivity);
}

bool material_is_transparent(const Material *material) {
    return color_is_any(&material->transparency);
}
