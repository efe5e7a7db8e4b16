/**
 * @file
 * @brief Opening of regular files without blocking, for paths that a scene names.
 */
#ifndef DIOPTRE_BASE_REGULAR_FILE_H
#define DIOPTRE_BASE_REGULAR_FILE_H

#include "base/error.h"

#include <fcntl.h>
#include <sys/stat.h>

/** Flags of an opening that cannot block: a FIFO or a device does not answer. */
#define REGULAR_FILE_FLAGS (O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)

/**
 * Opens a file for reading, without blocking.
 * @param path        Its path.
 * @param[out] info   Its properties.
 * @param[out] error  What is wrong (#STATUS_SCENE), without the path.
 * @return A file descriptor; -1 if it cannot be opened or is no regular file.
 */
int regular_file_open(const char *path, struct stat *info, Error *error);

/**
 * Checks that an open file is a regular file.
 * @param file        Its descriptor.
 * @param[out] info   Its properties.
 * @param[out] error  What is wrong (#STATUS_SCENE).
 * @return Whether it is.
 */
bool regular_file_check(int file, struct stat *info, Error *error);

/**
 * Reads the bytes of a regular file from its beginning.
 * @param file        Its descriptor.
 * @param[out] bytes  Memory for them.
 * @param size        Their number.
 * @param[out] error  What is wrong (#STATUS_SCENE).
 * @return false if it cannot be read, or has become shorter.
 */
bool regular_file_read(int file, char *bytes, size_t size, Error *error);

/**
 * Checks that size and times of a file have not changed.
 * @param file        Its descriptor.
 * @param before      Its properties when it was opened.
 * @param[out] error  What is wrong.
 * @return Whether they are the same.
 */
bool regular_file_is_unchanged(int file, const struct stat *before, Error *error);

#endif
