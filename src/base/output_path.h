/**
 * @file
 * @brief Targets of output paths.
 */
#ifndef DIOPTRE_BASE_OUTPUT_PATH_H
#define DIOPTRE_BASE_OUTPUT_PATH_H

#include <limits.h>
#include <stdbool.h>
#include <sys/types.h>

/** Target of an output path. */
typedef struct OutputPath {
    char path[PATH_MAX]; /**< Path, with symbolic links followed. */
    mode_t mode;         /**< Type and permissions of the existing file; 0: none exists. */
} OutputPath;

/**
 * Finds the target of a path: the end of its symbolic links, even if no file exists there.
 * @param[out] output  The target.
 * @param path         The path.
 * @return false with errno set: path too long, links in a cycle, a folder, or not writable.
 */
bool output_path_resolve(OutputPath *output, const char *path);

/**
 * @return Whether a target is written directly: a device, a FIFO or an open file of this process,
 *         which a rename would replace.
 * @param output  The target.
 */
bool output_path_is_direct(const OutputPath *output);

/**
 * @return Length of the part of a path that names its folder, with the slash; 0 without one.
 * @param path  The path.
 */
int output_path_dir_length(const char *path);

/**
 * Checks whether files can be created in the folder of a target.
 * @param output  The target.
 * @return false with errno set.
 */
bool output_path_dir_is_writable(const OutputPath *output);

#endif
