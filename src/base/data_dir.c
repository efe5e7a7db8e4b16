/**
 * @file
 * @brief Folders of installed data.
 */
#include "base/data_dir.h"

#include "base/executable_dir.h"

#include <stdio.h>
#include <unistd.h>

bool data_dir_scenes(char folder[PATH_MAX]) {
    char executable[PATH_MAX];
    return executable_dir(executable) &&
           snprintf(folder, PATH_MAX, "%s/../share/dioptre/scenes", executable) < PATH_MAX &&
           access(folder, R_OK | X_OK) == 0;
}
