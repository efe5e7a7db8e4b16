/**
 * @file
 * @brief Point lights.
 */
#ifndef DIOPTRE_LIGHT_H
#define DIOPTRE_LIGHT_H

#include "dioptre/parameter.h"

/** How light weakens on its way. */
typedef enum {
    FALLOFF_NONE,          /**< Not at all. */
    FALLOFF_INVERSE_SQUARE /**< With the square of the distance (row A6). */
} Falloff;

/** A lamp without size. Filled through #light_keyword. */
typedef struct Light {
    Vector3 position; /**< Where it is. */
    Color color;      /**< Its colour. */
    double intensity; /**< Multiplies the colour. */
    int falloff;      /**< A #Falloff. */
} Light;

/** The scene language's `light`. */
extern const Keyword light_keyword;

#endif
