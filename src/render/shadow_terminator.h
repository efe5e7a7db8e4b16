/**
 * @file
 * @brief Flat faces that are lit as though they were round: how much of a model float lights
 *        otherwise than double.
 *
 * A face of a model has its own plane, and light by normals that are turned towards its
 * neighbours'. Where a lamp stands a little behind the plane, those normals still see it, and only
 * the face itself is in its way. A ray to the lamp starts a rounding before the face and meets it
 * again after that length over the lamp's sine: if the face has ended by then, it is lit in float
 * and dark in double.
 */
#ifndef DIOPTRE_RENDER_SHADOW_TERMINATOR_H
#define DIOPTRE_RENDER_SHADOW_TERMINATOR_H

#include "dioptre/scene.h"

/** A model in a scene. */
typedef struct MeshInstance {
    const Scene *scene;         /**< The scene, with its lamps. */
    const Mesh *mesh;           /**< The model. */
    const Transform *transform; /**< How it stands there; NULL: as it is. */
    double ray_offset;          /**< How far before a face rays start in float, scene units. */
} MeshInstance;

/** @return The share of the model's surface that is lit in float and dark in double, summed over
 *  lamps. Of large models not every face is looked at. */
double shadow_terminator_fraction(const MeshInstance *instance);

#endif
