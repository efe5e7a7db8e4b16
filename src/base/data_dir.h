/**
 * @file
 * @brief Folders of the program's data.
 */
#ifndef DIOPTRE_BASE_DATA_DIR_H
#define DIOPTRE_BASE_DATA_DIR_H

#include <limits.h>
#include <stdbool.h>

/**
 * Finds the folder of the installed scenes.
 * @param[out] folder  The folder, absolute, without links, dots and a slash at its end.
 * @return Whether it exists.
 */
bool data_dir_installed_scenes(char folder[PATH_MAX]);

/**
 * Finds the folder of the program's scenes: the installed ones, or those of the checkout in which
 * the program was built. See #data_dir_installed_scenes.
 */
bool data_dir_scenes(char folder[PATH_MAX]);

#endif
