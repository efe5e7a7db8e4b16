/**
 * @file
 * @brief What was installed with the program.
 */
#ifndef DIOPTRE_BASE_DATA_DIR_H
#define DIOPTRE_BASE_DATA_DIR_H

#include <limits.h>
#include <stdbool.h>

/**
 * Finds the folder of the scenes that were installed with the program.
 * @param[out] folder  The folder, without a slash at its end.
 * @return Whether there is one.
 */
bool data_dir_scenes(char folder[PATH_MAX]);

#endif
