/**
 * @file
 * @brief Fields of a cylinder light besides the common ones.
 */
#ifndef DIOPTRE_SCENE_CYLINDER_LIGHT_H
#define DIOPTRE_SCENE_CYLINDER_LIGHT_H

#include "dioptre/scene.h"

/** Fields of a cylinder light. #SceneLight.position is its base, #SceneLight.radius its radius. */
typedef struct CylinderLightFields {
    Vec3d top; /**< Centre of the other end, scene units. */
} CylinderLightFields;

#endif
