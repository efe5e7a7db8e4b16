/**
 * @file
 * @brief The name and the format of a scene.
 */
#include "base/scene_name.h"

#include "base/base_name.h"

#include <stdio.h>
#include <string.h>
#include <strings.h>

void scene_name_from_path(const char *path, char *name, size_t size) {
    snprintf(name, size, "%s", strcmp(path, "-") == 0 ? "scene" : base_name(path));
    char *dot = strrchr(name, '.');
    if (dot && dot != name) {
        *dot = '\0';
    }
}

SceneFormat scene_format_of(const char *path) {
    const char *name = base_name(path);
    const char *ending = strrchr(name, '.');
    return !ending || ending == name         ? SCENE_FORMAT_NONE
           : strcasecmp(ending, ".nff") == 0 ? SCENE_FORMAT_NFF
           : strcmp(ending, ".lua") == 0     ? SCENE_FORMAT_LUA
                                             : SCENE_FORMAT_NONE;
}
