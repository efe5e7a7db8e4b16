/**
 * @file
 * @brief What a scene says of a rectangle light besides the common fields.
 */
#ifndef DIOPTRE_SCENE_RECTANGLE_LIGHT_H
#define DIOPTRE_SCENE_RECTANGLE_LIGHT_H

#include "dioptre/scene.h"

/** A rectangle light's own struct. #SceneLight.position is its corner. */
typedef struct RectangleLightFields {
    Vec3d u;        /**< Edge from the corner, scene units. */
    Vec3d v;        /**< The other edge; light goes to the side of u x v. */
    bool two_sided; /**< Whether light goes to both sides. */
} RectangleLightFields;

#endif
