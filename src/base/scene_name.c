/**
 * @file
 * @brief The name of a scene.
 */
#include "base/scene_name.h"

#include <stdio.h>
#include <string.h>

void scene_name_from_path(const char *path, char *name, size_t size) {
    const char *slash = strrchr(path, '/');
    snprintf(name, size, "%s", strcmp(path, "-") == 0 ? "scene" : slash ? slash + 1 : path);
    char *dot = strrchr(name, '.');
    if (dot && dot != name) {
        *dot = '\0';
    }
}
