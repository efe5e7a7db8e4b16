/**
 * @file
 * @brief Fields of a rectangle light besides the common ones.
 */
#ifndef DIOPTRE_SCENE_RECTANGLE_LIGHT_H
#define DIOPTRE_SCENE_RECTANGLE_LIGHT_H

#include "dioptre/scene.h"

/** Fields of a rectangle light. #SceneLight.position is its corner. */
typedef struct RectangleLightFields {
    Vec3d u;        /**< Edge from the corner, scene units. */
    Vec3d v;        /**< The other edge; light is emitted on the side of u x v. */
    bool two_sided; /**< Whether light is emitted on both sides. */
} RectangleLightFields;

#endif
