/**
 * @file
 * @brief Opening of regular files without blocking, for paths that a scene names.
 */
#ifndef DIOPTRE_BASE_REGULAR_FILE_H
#define DIOPTRE_BASE_REGULAR_FILE_H

#include "base/error.h"

#include <sys/stat.h>

/**
 * Opens a file for reading, without blocking.
 * @param path        Its path.
 * @param[out] info   Its properties.
 * @param[out] error  What is wrong (#STATUS_SCENE), without the path.
 * @return A file descriptor; -1 if it cannot be opened or is no regular file.
 */
int regular_file_open(const char *path, struct stat *info, Error *error);

/**
 * Checks that size and times of a file have not changed.
 * @param file        Its descriptor.
 * @param before      Its properties when it was opened.
 * @param[out] error  What is wrong.
 * @return Whether they are the same.
 */
bool regular_file_is_unchanged(int file, const struct stat *before, Error *error);

#endif
