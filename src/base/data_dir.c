/**
 * @file
 * @brief Folders of the program's data.
 */
#include "base/data_dir.h"

#include "base/executable_dir.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

/** Finds a folder by its path from that of the program. @param[out] folder The folder, without
 *  links and dots. @return Whether it exists. */
static bool find_folder(const char *path, char folder[PATH_MAX]) {
    char executable[PATH_MAX], joined[PATH_MAX];
    return executable_dir(executable) &&
           snprintf(joined, sizeof joined, "%s/%s", executable, path) < PATH_MAX &&
           realpath(joined, folder) && access(folder, R_OK | X_OK) == 0;
}

bool data_dir_installed_scenes(char folder[PATH_MAX]) {
    return find_folder("../share/dioptre/scenes", folder);
}

/** @return Whether there is a folder of scenes with one of lessons; another of its name has none.
 *  @param path Its path from the program. */
static bool find_scenes_with_lessons(const char *path, char folder[PATH_MAX]) {
    char lessons[PATH_MAX];
    return find_folder(path, folder) &&
           snprintf(lessons, sizeof lessons, "%s/lessons", folder) < PATH_MAX &&
           access(lessons, R_OK | X_OK) == 0;
}

bool data_dir_scenes(char folder[PATH_MAX]) {
    /** From a build; from a build with sanitizers, or tests; from tests of such a build. */
    static const char *const places[] = {"../scenes", "../../scenes", "../../../scenes"};
    bool is_found = data_dir_installed_scenes(folder);
    for (size_t i = 0; !is_found && i < sizeof places / sizeof *places; i++) {
        is_found = find_scenes_with_lessons(places[i], folder);
    }
    return is_found;
}
