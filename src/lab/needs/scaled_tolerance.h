/**
 * @file
 * @brief Scenes whose distance fields have other tolerances.
 */
#ifndef DIOPTRE_LAB_NEEDS_SCALED_TOLERANCE_H
#define DIOPTRE_LAB_NEEDS_SCALED_TOLERANCE_H

#include "dioptre/scene.h"

/** A scene whose distance fields have other tolerances. */
typedef struct ScaledToleranceScene {
    Scene scene;        /**< The scene; all but the following belongs to the original. */
    SceneShape *shapes; /**< Its shapes; owned. */
    char *parameters;   /**< Parameters of the shapes that differ; owned. */
} ScaledToleranceScene;

/** @return Whether a scene has shapes with a tolerance. */
bool scene_has_tolerances(const Scene *scene);

/**
 * Makes a scene whose tolerances are scaled.
 * @param[out] scaled  The scene, to be released with #scaled_tolerance_scene_deinit before the
 *                     original.
 * @return false without memory.
 */
bool scaled_tolerance_scene_init(ScaledToleranceScene *scaled, const Scene *scene, double factor,
                                 Error *error);

/** Releases a scaled scene, which may be empty. */
void scaled_tolerance_scene_deinit(ScaledToleranceScene *scaled);

#endif
