/**
 * @file
 * @brief The place that a path to be written stands for, and what is there already.
 */
#ifndef ASSETS_PLACE_H
#define ASSETS_PLACE_H

#include <limits.h>
#include <stdbool.h>
#include <sys/types.h>

/** A place for a file. */
typedef struct Place {
    char path[PATH_MAX]; /**< Where, symbolic links followed. */
    mode_t mode;         /**< Type and permissions of what is there; 0: nothing is. */
} Place;

/**
 * Finds the place that a path stands for: at the end of its symbolic links, even where nothing is
 * there yet.
 * @param[out] place  The place.
 * @param path        The path.
 * @return false with errno set: too long, links in a ring, a folder, or may not be written.
 */
bool place_find(Place *place, const char *path);

/**
 * Says whether a place is written to directly: whether there is a device, a FIFO or a file that
 * this process has open. To put another file there would cut it off.
 * @param place  The place.
 * @return Whether it is.
 */
bool place_is_direct(const Place *place);

/**
 * Bytes of a path that name its folder.
 * @param path  A path.
 * @return Place after the last slash; 0 without one.
 */
int place_folder_length(const char *path);

/**
 * Says whether files can be made in the folder of a place.
 * @param place  The place.
 * @return false with errno set.
 */
bool place_has_folder(const Place *place);

#endif
