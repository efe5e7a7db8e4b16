/**
 * @file
 * @brief Where the program itself lies: its modules and its words lie beside it.
 */
#ifndef ASSETS_OWN_FOLDER_H
#define ASSETS_OWN_FOLDER_H

#include <limits.h>
#include <stdbool.h>

/**
 * Finds the folder of the program.
 * @param[out] folder  The folder, without a slash at its end.
 * @return false when it cannot be found or its name is too long.
 */
bool own_folder(char folder[PATH_MAX]);

#endif
