/**
 * @file
 * @brief The place that a path to be written stands for, and what is there already.
 */
#ifndef DIOPTRE_BASE_OUTPUT_PATH_H
#define DIOPTRE_BASE_OUTPUT_PATH_H

#include <limits.h>
#include <stdbool.h>
#include <sys/types.h>

/** A place for a file. */
typedef struct OutputPath {
    char path[PATH_MAX]; /**< Where, symbolic links followed. */
    mode_t mode;         /**< Type and permissions of what is there; 0: nothing is. */
} OutputPath;

/** Finds the place that a path stands for: at the end of its symbolic links, even where nothing is
 *  there yet. @return false with errno set: too long, links in a ring, a folder, or may not be
 *  written. */
bool output_path_resolve(OutputPath *output, const char *path);

/** Says whether a place is written to directly: whether there is a device, a FIFO or a file that
 *  this process has open. To put another file there would cut it off. @return Whether it is. */
bool output_path_is_direct(const OutputPath *output);

/** Bytes of a path that name its folder. @return Place after the last slash; 0 without one. */
int output_path_dir_length(const char *path);

/** Says whether files can be made in the folder of a place. @return false with errno set. */
bool output_path_dir_is_writable(const OutputPath *output);

#endif
