/**
 * @file
 * @brief Lights: lamps at a point, with or without size, and suns.
 */
#ifndef DIOPTRE_LIGHT_H
#define DIOPTRE_LIGHT_H

#include "dioptre/parameter.h"

/** What a light is. */
typedef enum {
    SCENE_LIGHT_POINT, /**< A lamp at a point, or a glowing ball around it (row D4). */
    SCENE_LIGHT_SUN    /**< A lamp infinitely far away: its light is parallel (row B4). */
} SceneLightKind;

/** How light weakens on its way. */
typedef enum {
    FALLOFF_NONE,          /**< Not at all. */
    FALLOFF_INVERSE_SQUARE /**< With the square of the distance (row A6). */
} Falloff;

/** A light. Filled through #scene_light_keyword or #scene_sun_keyword. */
typedef struct SceneLight {
    SceneLightKind kind; /**< What it is. */
    Rgbd color;          /**< Its colour. */
    double intensity;    /**< Multiplies the colour. */
    Vec3d position;      /**< A lamp's: where it is. */
    double radius;       /**< A lamp's: of the ball as which it is seen, scene units; 0: unseen. */
    int falloff;         /**< A lamp's: a #Falloff. */
    Vec3d direction;     /**< A sun's: the way that its light travels; not zero. */
} SceneLight;

/** The scene language's `light`. */
extern const Keyword scene_light_keyword;

/** The scene language's `sun`. */
extern const Keyword scene_sun_keyword;

/** @return The keyword that says a light in the scene language. @param light The light. */
const Keyword *scene_light_keyword_for(const SceneLight *light);

/** @return Whether a light is seen. @param light The light. */
bool scene_light_is_spherical(const SceneLight *light);

/**
 * Moves a lamp. A sun is turned instead, as though it were a lamp not far away, so that the same
 * way moves its shadows alike.
 * @param[in,out] light  The light.
 * @param offset            How far, scene units.
 * @param distance       How far away a sun is taken to be, scene units.
 */
void scene_light_move(SceneLight *light, Vec3d offset, double distance);

#endif
