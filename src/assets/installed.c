/**
 * @file
 * @brief What was installed with the program.
 */
#include "dioptre/installed.h"

#include "assets/own_folder.h"

#include <stdio.h>
#include <unistd.h>

bool installed_scenes(char folder[PATH_MAX]) {
    char own[PATH_MAX];
    return own_folder(own) &&
           snprintf(folder, PATH_MAX, "%s/../share/dioptre/scenes", own) < PATH_MAX &&
           access(folder, R_OK | X_OK) == 0;
}
