/**
 * @file
 * @brief The folder of the program, near which its modules and translations lie.
 */
#ifndef DIOPTRE_BASE_EXECUTABLE_DIR_H
#define DIOPTRE_BASE_EXECUTABLE_DIR_H

#include <limits.h>
#include <stdbool.h>

/**
 * Finds the folder of the program.
 * @param[out] folder  The folder, without a slash at its end.
 * @return false if it cannot be found or its path is too long.
 */
bool executable_dir(char folder[PATH_MAX]);

#endif
