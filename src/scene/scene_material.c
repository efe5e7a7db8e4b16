/**
 * @file
 * @brief Materials.
 */
#include "base/language.h"
#include "dioptre/scene.h"

/** Largest weight of a term. It is above 1, so that demonstrations can exaggerate a highlight. */
#define WEIGHT_MAXIMUM 1000.0
/** Largest exponent; its highlight is smaller than a pixel, and at the limit of float. */
#define SHININESS_MAXIMUM 1e6
/**
 * Largest sum of reflectivity and transparency: 1, plus the rounding error of numbers like 0.9 and
 * 0.1.
 */
#define REFLECTANCE_SUM_MAXIMUM (1 + 1e-9)
/** Smallest index of refraction; values below 1 occur only for X-rays and in demonstrations. */
#define IOR_MINIMUM 0.01
/** Largest index of refraction; that of diamond is 2.4. */
#define IOR_MAXIMUM 100.0

/** Fields of `material`. */
static const Parameter scene_material_parameters[] = {
    {.name = "color",
     .type = PARAMETER_COLOR,
     .offset = offsetof(SceneMaterial, color),
     .minimum = 0,
     .maximum = 1,
     .unit = N_("share"),
     .help = N_("light that a matt surface sends back")},
    {.name = "texture",
     .type = PARAMETER_TEXTURE,
     .offset = offsetof(SceneMaterial, texture_id),
     .unit = N_("file"),
     .help = N_("a picture that multiplies color")},
    {.name = "ambient",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(SceneMaterial, ambient),
     .minimum = 0,
     .maximum = WEIGHT_MAXIMUM,
     .unit = N_("weight"),
     .help = N_("of the light from everywhere")},
    {.name = "diffuse",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(SceneMaterial, diffuse),
     .minimum = 0,
     .maximum = WEIGHT_MAXIMUM,
     .unit = N_("weight"),
     .help = N_("of each light's matt shine")},
    {.name = "specular",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(SceneMaterial, specular),
     .minimum = 0,
     .maximum = WEIGHT_MAXIMUM,
     .unit = N_("weight"),
     .help = N_("of each light's highlight")},
    {.name = "shininess",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(SceneMaterial, shininess),
     .minimum = 0,
     .maximum = SHININESS_MAXIMUM,
     .unit = N_("exponent"),
     .help = N_("the larger, the smaller the highlight")},
    {.name = "reflectivity",
     .type = PARAMETER_COLOR,
     .offset = offsetof(SceneMaterial, reflectivity),
     .minimum = 0,
     .maximum = 1,
     .unit = N_("share"),
     .help = N_("of light that is mirrored")},
    {.name = "transparency",
     .type = PARAMETER_COLOR,
     .offset = offsetof(SceneMaterial, transparency),
     .minimum = 0,
     .maximum = 1,
     .unit = N_("share"),
     .help = N_("of light that is let through")},
    {.name = "ior",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(SceneMaterial, ior),
     .minimum = IOR_MINIMUM,
     .maximum = IOR_MAXIMUM,
     .unit = N_("times that of air"),
     .help = N_("index of refraction inside")},
    {.name = "emission",
     .type = PARAMETER_COLOR,
     .offset = offsetof(SceneMaterial, emission),
     .minimum = 0,
     .maximum = INTENSITY_MAXIMUM,
     .unit = N_("linear light"),
     .help = N_("light of its own")},
    {0}};

/** Diffuse white. */
static const SceneMaterial scene_material_defaults = {
    .color = {1, 1, 1}, .ambient = 1, .diffuse = 1, .shininess = 50, .ior = 1.5};

/**
 * Rejects materials that return more light than arrives. See #Keyword.finish.
 * @return Whether the sum of reflectivity and transparency is at most 1.
 */
static bool scene_material_finish(void *values, uint64_t given, Error *error) {
    (void)given;
    const SceneMaterial *m = values;
    const Rgbd *reflected = &m->reflectivity, *transmitted = &m->transparency;
    double maximum =
        fmax(reflected->red + transmitted->red,
             fmax(reflected->green + transmitted->green, reflected->blue + transmitted->blue));
    return maximum <= REFLECTANCE_SUM_MAXIMUM ||
           error_set(error, STATUS_SCENE,
                     "reflectivity and transparency are %g together; they must be at most 1 in "
                     "red, green and blue",
                     maximum);
}

const Keyword scene_material_keyword = {.name = "material",
                                        .help = "what a surface does with light",
                                        .parameters = scene_material_parameters,
                                        .size = sizeof(SceneMaterial),
                                        .defaults = &scene_material_defaults,
                                        .finish = scene_material_finish};

/** @return Whether any channel is above zero. */
static bool rgbd_is_nonzero(const Rgbd *color) {
    return color->red > 0 || color->green > 0 || color->blue > 0;
}

bool scene_material_is_reflective(const SceneMaterial *material) {
    return rgbd_is_nonzero(&material->reflectivity);
}

bool scene_material_is_transparent(const SceneMaterial *material) {
    return rgbd_is_nonzero(&material->transparency);
}

bool scene_material_is_secondary(const SceneMaterial *material) {
    return scene_material_is_reflective(material) || scene_material_is_transparent(material);
}
