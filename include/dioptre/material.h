/**
 * @file
 * @brief What a surface does with light.
 */
#ifndef DIOPTRE_MATERIAL_H
#define DIOPTRE_MATERIAL_H

#include "dioptre/parameter.h"

/** A surface. Filled through #material_keyword; the model is in doc/scene-reference.md. */
typedef struct Material {
    Color color;        /**< Share of light that a matt surface sends back, per primary. */
    size_t texture;     /**< Place in `Scene.textures`, plus one, of what multiplies the colour; 0:
                             nothing does. */
    double ambient;     /**< Weight of the light from everywhere. */
    double diffuse;     /**< Weight of each light's matt shine. */
    double specular;    /**< Weight of each light's highlight (Phong). */
    double shininess;   /**< Exponent of the highlight: the larger, the smaller it is. */
    Color reflectivity; /**< Share of light that is mirrored, 0 to 1. */
    Color transparency; /**< Share of light that is let through; 1 at most with #reflectivity. */
    double ior;         /**< Index of refraction inside; 1 is air. */
    Color emission;     /**< Light of its own. */
} Material;

/** The scene language's `material`. */
extern const Keyword material_keyword;

/** @return Whether a surface mirrors anything. @param material A material. */
bool material_is_mirror(const Material *material);

/** @return Whether a surface lets anything through. @param material A material. */
bool material_is_transparent(const Material *material);

#endif
