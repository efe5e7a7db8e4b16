/**
 * @file
 * @brief The files that a scene names: beside it, or in a folder below.
 */
#ifndef DIOPTRE_SCRIPT_ASSET_PATH_H
#define DIOPTRE_SCRIPT_ASSET_PATH_H

#include "dioptre/script.h"

#include <limits.h>

/**
 * Finds a file that a scene names; symbolic links are followed, and count by where they lead.
 * @param name  The file's name, from the folder that the scene's files lie in.
 * @param[out] display_path  Its path as the user knows it.
 * @param[out] real_path  Its path without links.
 * @return false if there is none, or it lies outside.
 */
bool asset_path_resolve(const ScriptRequest *request, const char *name, char display_path[PATH_MAX],
                        char real_path[PATH_MAX], Error *error);

#endif
