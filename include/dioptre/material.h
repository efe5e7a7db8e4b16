/**
 * @file
 * @brief What a surface does with light.
 */
#ifndef DIOPTRE_MATERIAL_H
#define DIOPTRE_MATERIAL_H

#include "dioptre/parameter.h"

/** A surface. Filled through #scene_material_keyword; the model is in doc/scene-reference.md. */
typedef struct SceneMaterial {
    Rgbd color;        /**< Share of light that a matt surface sends back, per primary. */
    size_t texture_id; /**< Place in `Scene.textures`, plus one, of what multiplies the colour; 0:
                         nothing does. */
    double ambient;    /**< Weight of the light from everywhere. */
    double diffuse;    /**< Weight of each light's matt shine. */
    double specular;   /**< Weight of each light's highlight (Phong). */
    double shininess;  /**< Exponent of the highlight: the larger, the smaller it is. */
    Rgbd reflectivity; /**< Share of light that is mirrored, 0 to 1. */
    Rgbd transparency; /**< Share of light that is let through; 1 at most with #reflectivity. */
    double ior;        /**< Index of refraction inside; 1 is air. */
    Rgbd emission;     /**< Light of its own. */
} SceneMaterial;

/** The scene language's `material`. */
extern const Keyword scene_material_keyword;

/** @return Whether a surface mirrors anything. @param material A material. */
bool scene_material_is_reflective(const SceneMaterial *material);

/** @return Whether a surface lets anything through. @param material A material. */
bool scene_material_is_transparent(const SceneMaterial *material);

#endif
