/**
 * @file
 * @brief Files of strangers, opened so that nothing can keep the program waiting.
 */
#ifndef DIOPTRE_BASE_REGULAR_FILE_H
#define DIOPTRE_BASE_REGULAR_FILE_H

#include "base/error.h"

#include <sys/stat.h>

/**
 * Opens a file to be read, without waiting.
 * @param[out] info  What is known of it.
 * @param[out] error  Why not (#STATUS_SCENE), without the path.
 * @return A file descriptor; -1 if it cannot be opened or is no regular file.
 */
int regular_file_open(const char *path, struct stat *info, Error *error);

/**
 * Says whether a file is still what it was.
 * @param before  What was known of it.
 * @return Whether it is.
 */
bool regular_file_is_unchanged(int file, const struct stat *before, Error *error);

#endif
