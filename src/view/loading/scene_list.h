/**
 * @file
 * @brief The scenes of some folders with thumbnails: found and drawn by a thread of low priority.
 */
#ifndef DIOPTRE_VIEW_LOADING_SCENE_LIST_H
#define DIOPTRE_VIEW_LOADING_SCENE_LIST_H

#include "dioptre/view.h"
#include "view/loading/scene_title.h"

#include <limits.h>
#include <pthread.h>
#include <time.h>

/** Most scenes of a list. */
enum { SCENE_LIST_MAXIMUM = 999 };
/** Width of a thumbnail, pixels. */
enum { THUMBNAIL_WIDTH = 240 };
/** Height of a thumbnail, pixels. */
enum { THUMBNAIL_HEIGHT = 180 };
/** Bytes of a scene's name with the final zero; a longer one is cut. */
enum { SCENE_ENTRY_NAME_SIZE = 64 };

/** A scene or a lesson of the list. */
typedef struct SceneEntry {
    char *path;                        /**< Its file; owned. */
    char name[SCENE_ENTRY_NAME_SIZE];  /**< Its name: that of the file. */
    char label[SCENE_ENTRY_NAME_SIZE]; /**< Its name for readers. */
    char title[SCENE_TITLE_SIZE];      /**< Its title, see #scene_title_read, or its error. */
    bool is_lesson;                    /**< Whether it is a lesson. */
    LessonSummary summary;             /**< What it is about, if so. */
    bool is_loaded;                    /**< Whether it was drawn or has an error. */
    bool is_in_sight;                  /**< Whether it is on screen: those are drawn first. */
    struct timespec modified;          /**< When its file was last modified. */
    Picture picture; /**< Its thumbnail; empty: not drawn yet, or an error; owned. */
} SceneEntry;

/** The list, and the thread that fills it. Starts as `{0}`: empty. */
typedef struct SceneList {
    const ViewSettings *settings; /**< How scenes are loaded. */
    uint32_t event;               /**< SDL event of a change of the list. */
    char folder[PATH_MAX];        /**< First folder; the installed scenes follow. */
    pthread_t thread;             /**< The thread. */
    bool is_started;              /**< Whether the thread must be joined. */
    atomic_bool should_stop;      /**< Whether the thread should end. */
    atomic_bool is_running;       /**< Whether the thread works. */
    atomic_bool is_complete;      /**< Whether all scenes were found. */
    SceneEntry *kept;             /**< What was listed before, until the thread has found the
                                       scenes; owned; NULL: nothing. */
    size_t kept_count;            /**< Number of #kept. */
    pthread_mutex_t mutex;        /**< Locks the members below. */
    SceneEntry *scenes;           /**< The scenes; owned. */
    size_t count;                 /**< Number of scenes. */
} SceneList;

/**
 * Starts to fill a list. A list that was filled before keeps the thumbnails of the files that were
 * not modified since: also of those whose models or pictures were.
 * @param[in,out] list  Empty, or one that is not busy.
 * @param event  SDL event, registered, to send when the list changes.
 * @param path  A scene file, whose folder is listed.
 * @return false if the thread cannot start.
 */
bool scene_list_start(SceneList *list, const ViewSettings *settings, uint32_t event,
                      const char *path);

/** Asks the thread to end, without waiting. */
void scene_list_request_stop(SceneList *list);

/** Frees a list; waits for its thread, at most as long as it takes to build one BVH. */
void scene_list_deinit(SceneList *list);

/** @return Whether the thread works. */
bool scene_list_is_busy(const SceneList *list);

/** Locks the list against the thread, until #scene_list_unlock. */
void scene_list_lock(SceneList *list);

/** Unlocks the list. */
void scene_list_unlock(SceneList *list);

#endif
