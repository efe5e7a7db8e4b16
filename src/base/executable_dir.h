/**
 * @file
 * @brief Where the program itself lies: its modules and its words lie beside it.
 */
#ifndef DIOPTRE_BASE_EXECUTABLE_DIR_H
#define DIOPTRE_BASE_EXECUTABLE_DIR_H

#include <limits.h>
#include <stdbool.h>

/**
 * Finds the folder of the program.
 * @param[out] folder  The folder, without a slash at its end.
 * @return false when it cannot be found or its name is too long.
 */
bool executable_dir(char folder[PATH_MAX]);

#endif
