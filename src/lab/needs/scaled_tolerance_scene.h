/**
 * @file
 * @brief A scene with other tolerances of its distance fields.
 */
#ifndef DIOPTRE_LAB_NEEDS_SCALED_TOLERANCE_SCENE_H
#define DIOPTRE_LAB_NEEDS_SCALED_TOLERANCE_SCENE_H

#include "dioptre/scene.h"

/** A scene that differs from another in its shapes only. */
typedef struct ScaledToleranceScene {
    Scene scene;        /**< The scene; what is not of its own belongs to the other. */
    SceneShape *shapes; /**< Its shapes; owned. */
    char *parameters;   /**< Those that differ; owned. */
} ScaledToleranceScene;

/** @return Whether a scene has shapes that are marched. */
bool scene_has_tolerances(const Scene *scene);

/**
 * Makes a scene whose tolerances are so many times as large.
 * @param[out] scaled  The scene, to be given back with #scaled_tolerance_scene_deinit before the
 *         other is.
 * @return false without memory.
 */
bool scaled_tolerance_scene_init(ScaledToleranceScene *scaled, const Scene *scene, double factor,
                                 Error *error);

/** Gives back what is its own. @param scaled It; may be empty. */
void scaled_tolerance_scene_deinit(ScaledToleranceScene *scaled);

#endif
