/**
 * @file
 * @brief A scene file under watch: an event of the window tells that it was written.
 *
 * The folder is watched, not the file: editors write a new file and rename it into its place. What
 * a scene file includes stands beside it, so that any Lua file that is written there counts.
 */
#ifndef DIOPTRE_VIEW_LOADING_FILE_WATCHER_H
#define DIOPTRE_VIEW_LOADING_FILE_WATCHER_H

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

/** A watch. Starts as `{.files = -1}`: nothing is watched. */
typedef struct FileWatcher {
    int inotify;      /**< What the system tells; a file descriptor, or -1. */
    int watch_id;     /**< Which folder; the system's number for it. */
    int stop_event;   /**< Written to end the thread; a file descriptor. */
    uint32_t event;   /**< SDL event, registered, that tells. */
    pthread_t thread; /**< The thread that waits. */
} FileWatcher;

/**
 * Begins to watch. Where that cannot be done, nothing is told, and nothing else is wrong.
 * @param[out] watcher  The watch; end it with #file_watcher_stop.
 * @param event       SDL event, registered, that tells.
 */
void file_watcher_start(FileWatcher *watcher, uint32_t event);

/** Watches the folder of a file from now on, in place of any other. */
void file_watcher_watch(FileWatcher *watcher, const char *path);

/** Ends a watch. */
void file_watcher_stop(FileWatcher *watcher);

#endif
