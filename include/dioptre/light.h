/**
 * @file
 * @brief Lights: lamps at a point, with or without size, and suns.
 */
#ifndef DIOPTRE_LIGHT_H
#define DIOPTRE_LIGHT_H

#include "dioptre/parameter.h"

/** What a light is. */
typedef enum {
    LIGHT_POINT, /**< A lamp at a point, or a glowing ball around it (row D4). */
    LIGHT_SUN    /**< A lamp infinitely far away: its light is parallel (row B4). */
} LightKind;

/** How light weakens on its way. */
typedef enum {
    FALLOFF_NONE,          /**< Not at all. */
    FALLOFF_INVERSE_SQUARE /**< With the square of the distance (row A6). */
} Falloff;

/** A light. Filled through #light_keyword or #sun_keyword. */
typedef struct Light {
    LightKind kind;    /**< What it is. */
    Color color;       /**< Its colour. */
    double intensity;  /**< Multiplies the colour. */
    Vector3 position;  /**< A lamp's: where it is. */
    double radius;     /**< A lamp's: of the ball as which it is seen, scene units; 0: unseen. */
    int falloff;       /**< A lamp's: a #Falloff. */
    Vector3 direction; /**< A sun's: the way that its light travels; not zero. */
} Light;

/** The scene language's `light`. */
extern const Keyword light_keyword;

/** The scene language's `sun`. */
extern const Keyword sun_keyword;

/** @return The keyword that says a light in the scene language. @param light The light. */
const Keyword *light_keyword_of(const Light *light);

/** @return Whether a light is seen. @param light The light. */
bool light_is_ball(const Light *light);

/**
 * Moves a lamp. A sun is turned instead, as though it were a lamp not far away, so that the same
 * way moves its shadows alike.
 * @param[in,out] light  The light.
 * @param way            How far, scene units.
 * @param distance       How far away a sun is taken to be, scene units.
 */
void light_move(Light *light, Vector3 way, double distance);

#endif
