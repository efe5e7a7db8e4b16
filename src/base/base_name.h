/**
 * @file
 * @brief The name of a file without its folder.
 */
#ifndef DIOPTRE_BASE_BASE_NAME_H
#define DIOPTRE_BASE_BASE_NAME_H

#include <string.h>

/** @return The part of a path after its last slash. @param path The path, which owns the name. */
static inline const char *base_name(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

#endif
