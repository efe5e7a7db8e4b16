/**
 * @file
 * @brief Paths of the files that a scene names.
 */
#include "script/asset_path.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/**
 * Finds the folder of the files of a scene.
 * @param request   The request.
 * @param[out] dir  The folder as the user gave it, with a slash at its end; empty: the working
 *                  directory.
 */
static void find_base_dir(const ScriptRequest *request, char dir[PATH_MAX]) {
    if (request->base_dir) {
        snprintf(dir, PATH_MAX, "%s/", request->base_dir);
        return;
    }
    const char *slash = strrchr(request->path, '/');
    int length = slash ? (int)(slash + 1 - request->path) : 0;
    snprintf(dir, PATH_MAX, "%.*s", length, request->path);
}

/** @return Whether a path lies below a folder. */
static bool is_inside(const char *dir, const char *path) {
    size_t length = strlen(dir);
    if (strcmp(dir, "/") == 0) {
        return true;
    }
    return strncmp(dir, path, length) == 0 && path[length] == '/';
}

bool asset_path_resolve(const ScriptRequest *request, const char *name, char display_path[PATH_MAX],
                        char real_path[PATH_MAX], Error *error) {
    char dir[PATH_MAX], real_dir[PATH_MAX];
    find_base_dir(request, dir);
    bool is_short = snprintf(display_path, PATH_MAX, "%s%s", dir, name) < PATH_MAX;
    if (!is_short || name[0] == '/') {
        return error_set(error, STATUS_SCENE, "its name must say where it is from the scene file");
    }
    if (!realpath(dir[0] ? dir : ".", real_dir) || !realpath(display_path, real_path)) {
        return error_set(error, STATUS_SCENE, "%s", error_errno_text(errno));
    }
    if (!is_inside(real_dir, real_path)) {
        return error_set(error, STATUS_SCENE, "it lies outside the scene's folder");
    }
    return true;
}
