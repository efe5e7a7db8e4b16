/**
 * @file
 * @brief What was installed with the program.
 */
#ifndef DIOPTRE_INSTALLED_H
#define DIOPTRE_INSTALLED_H

#include <limits.h>
#include <stdbool.h>

/**
 * Finds the folder of the scenes that were installed with the program.
 * @param[out] folder  The folder, without a slash at its end.
 * @return Whether there is one.
 */
bool installed_scenes(char folder[PATH_MAX]);

#endif
