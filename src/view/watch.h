/**
 * @file
 * @brief A scene file under watch: an event of the window tells that it was written.
 *
 * The folder is watched, not the file: editors write a new file and rename it into its place. What
 * a scene file includes stands beside it, so that any Lua file that is written there counts.
 */
#ifndef DIOPTRE_VIEW_WATCH_H
#define DIOPTRE_VIEW_WATCH_H

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

/** A watch. Starts as `{.files = -1}`: nothing is watched. */
typedef struct Watch {
    int files;        /**< What the system tells; a file descriptor, or -1. */
    int folder;       /**< Which folder; the system's number for it. */
    int end;          /**< Written to end the thread; a file descriptor. */
    uint32_t event;   /**< SDL event, registered, that tells. */
    pthread_t thread; /**< The thread that waits. */
} Watch;

/**
 * Begins to watch. Where that cannot be done, nothing is told, and nothing else is wrong.
 * @param[out] watch  The watch; end it with #watch_end.
 * @param event       SDL event, registered, that tells.
 */
void watch_begin(Watch *watch, uint32_t event);

/** Watches the folder of a file from now on, in place of any other. @param[in,out] watch The watch.
 *  @param path The file. */
void watch_file(Watch *watch, const char *path);

/** Ends a watch. @param[in,out] watch The watch. */
void watch_end(Watch *watch);

#endif
