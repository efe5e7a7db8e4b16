/**
 * @file
 * @brief Paths of the files that a scene names: in its folder or below.
 */
#ifndef DIOPTRE_SCRIPT_ASSET_PATH_H
#define DIOPTRE_SCRIPT_ASSET_PATH_H

#include "dioptre/script.h"

#include <limits.h>

/**
 * Finds a file that a scene names. Symbolic links are followed; their targets must be in the
 * folder.
 * @param request            The request, with the folder.
 * @param name               Name of the file, relative to the folder of the scene.
 * @param[out] display_path  Its path for messages.
 * @param[out] real_path     Its absolute path without links.
 * @param[out] error         What is wrong.
 * @return false if there is no such file, or if it lies outside the folder.
 */
bool asset_path_resolve(const ScriptRequest *request, const char *name, char display_path[PATH_MAX],
                        char real_path[PATH_MAX], Error *error);

#endif
