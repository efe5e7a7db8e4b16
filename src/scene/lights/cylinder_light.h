/**
 * @file
 * @brief What a scene says of a cylinder light besides the common fields.
 */
#ifndef DIOPTRE_SCENE_CYLINDER_LIGHT_H
#define DIOPTRE_SCENE_CYLINDER_LIGHT_H

#include "dioptre/scene.h"

/** A cylinder light's own struct. #SceneLight.position is its base, #SceneLight.radius its radius.
 */
typedef struct CylinderLightFields {
    Vec3d top; /**< Centre of the other end, scene units. */
} CylinderLightFields;

#endif
