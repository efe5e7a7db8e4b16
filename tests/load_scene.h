/**
 * @file
 * @brief Scenes of this project for tests.
 */
#ifndef DIOPTRE_TESTS_LOAD_SCENE_H
#define DIOPTRE_TESTS_LOAD_SCENE_H

#include "testing.h"

#include "dioptre/script.h"

/** @return A scene of this project, loaded. */
static inline Scene *load_scene(const char *path) {
    Error error = {0};
    ScriptRequest request = {
        .path = path, .time_limit = SCRIPT_TIME_LIMIT, .memory_limit = SCRIPT_MEMORY_LIMIT};
    Scene *scene = script_load(&request, &error);
    if (!scene) {
        fail_msg("%s", error.message);
    }
    return scene;
}

#endif
