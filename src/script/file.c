/**
 * @file
 * @brief The files that a scene names.
 */
#include "script/file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/**
 * Finds the folder that a scene's files lie in.
 * @param request      What was asked for.
 * @param[out] folder  The folder, as the user knows it, with a slash at its end; empty for the
 *                     folder that the program runs in.
 */
static void find_folder(const ScriptRequest *request, char folder[PATH_MAX]) {
    if (request->base_dir) {
        snprintf(folder, PATH_MAX, "%s/", request->base_dir);
        return;
    }
    const char *slash = strrchr(request->path, '/');
    int length = slash ? (int)(slash + 1 - request->path) : 0;
    snprintf(folder, PATH_MAX, "%.*s", length, request->path);
}

/**
 * Says whether a path lies below a folder.
 * @param folder  The folder, real.
 * @param path    The path, real.
 * @return Whether it does.
 */
static bool is_below(const char *folder, const char *path) {
    size_t length = strlen(folder);
    if (strcmp(folder, "/") == 0) {
        return true;
    }
    return strncmp(folder, path, length) == 0 && path[length] == '/';
}

bool file_find(const ScriptRequest *request, const char *name, char shown[PATH_MAX],
               char real[PATH_MAX], Error *error) {
    char folder[PATH_MAX], real_folder[PATH_MAX];
    find_folder(request, folder);
    bool is_short = snprintf(shown, PATH_MAX, "%s%s", folder, name) < PATH_MAX;
    if (!is_short || name[0] == '/') {
        return error_set(error, STATUS_SCENE, "its name must say where it is from the scene file");
    }
    if (!realpath(folder[0] ? folder : ".", real_folder) || !realpath(shown, real)) {
        return error_set(error, STATUS_SCENE, "%s", error_system(errno));
    }
    if (!is_below(real_folder, real)) {
        return error_set(error, STATUS_SCENE, "it lies outside the scene's folder");
    }
    return true;
}
