/**
 * @file
 * @brief Watches the scene's file: a thread sends an event when it was written.
 *
 * The folder is watched, as editors write a new file and rename it. Included files are in the same
 * folder, so each Lua file written there counts.
 */
#ifndef DIOPTRE_VIEW_LOADING_FILE_WATCHER_H
#define DIOPTRE_VIEW_LOADING_FILE_WATCHER_H

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

/** A watch. */
typedef struct FileWatcher {
    int inotify;      /**< File descriptor of inotify; -1: there is no watch. */
    int watch_id;     /**< The watched folder, as inotify's number; -1: none. */
    int stop_event;   /**< File descriptor of an eventfd that ends the thread. */
    uint32_t event;   /**< SDL event to send. */
    pthread_t thread; /**< The thread. */
} FileWatcher;

/** Starts the thread. Without inotify nothing is watched, which is no error. @param[out] watcher To
 * be stopped with #file_watcher_stop. @param event SDL event, registered, to send. */
void file_watcher_start(FileWatcher *watcher, uint32_t event);

/** Watches the folder of a file instead of any other. */
void file_watcher_watch(FileWatcher *watcher, const char *path);

/** Stops the thread. */
void file_watcher_stop(FileWatcher *watcher);

#endif
