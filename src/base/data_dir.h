/**
 * @file
 * @brief Folders of installed data.
 */
#ifndef DIOPTRE_BASE_DATA_DIR_H
#define DIOPTRE_BASE_DATA_DIR_H

#include <limits.h>
#include <stdbool.h>

/**
 * Finds the folder of the installed scenes.
 * @param[out] folder  The folder, without a slash at its end.
 * @return Whether it exists.
 */
bool data_dir_scenes(char folder[PATH_MAX]);

#endif
