/**
 * @file
 * @brief The folder of the program.
 */
#include "base/executable_dir.h"

#include <string.h>
#include <unistd.h>

bool executable_dir(char folder[PATH_MAX]) {
    ssize_t length = readlink("/proc/self/exe", folder, PATH_MAX - 1);
    if (length < 0) {
        return false;
    }
    folder[length] = '\0';
    char *slash = strrchr(folder, '/');
    if (!slash) {
        return false;
    }
    *slash = '\0';
    return true;
}
