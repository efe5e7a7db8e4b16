/**
 * @file
 * @brief The scenes of some folders, with small pictures of them: found and drawn by a thread of
 *        low priority, one after another, while the window lives on.
 */
#ifndef DIOPTRE_VIEW_LOADING_SCENE_LIST_H
#define DIOPTRE_VIEW_LOADING_SCENE_LIST_H

#include "dioptre/view.h"

#include <limits.h>
#include <pthread.h>

/** Most scenes of a list. */
enum { SCENE_LIST_MAXIMUM = 999 };
/** Pixels that a small picture is wide. */
enum { THUMBNAIL_WIDTH = 240 };
/** Pixels that it is high. */
enum { THUMBNAIL_HEIGHT = 180 };
/** Bytes of a scene's name and of its title, with the final zero; longer ones are cut. */
enum { SCENE_ENTRY_NAME_SIZE = 64, SCENE_ENTRY_TITLE_SIZE = 256 };

/** A scene of the list. */
typedef struct SceneEntry {
    char *path;                         /**< Its file; owned. */
    char name[SCENE_ENTRY_NAME_SIZE];   /**< Its name. */
    char title[SCENE_ENTRY_TITLE_SIZE]; /**< What its file begins with, or what is wrong with it. */
    bool is_loaded;                     /**< Whether it was drawn, or found to be wrong. */
    Picture picture; /**< It, small; empty: it is wrong, or not drawn yet; owned. */
} SceneEntry;

/** The list, and the thread that fills it. Starts as `{0}`: empty. */
typedef struct SceneList {
    const ViewSettings *settings; /**< How scenes are loaded. */
    uint32_t event;               /**< SDL event, registered, that tells of news. */
    char folder[PATH_MAX];        /**< Where to look first; in the installed scenes then. */
    pthread_t thread;             /**< The thread. */
    bool is_started;              /**< Whether there is a thread to be joined. */
    atomic_bool should_stop;      /**< Whether to end, soon. */
    atomic_bool is_running;       /**< Whether the thread is at work. */
    pthread_mutex_t mutex;        /**< Guards what follows. */
    SceneEntry *scenes;           /**< The scenes; owned. */
    size_t count;                 /**< How many. */
} SceneList;

/**
 * Begins to fill a list. It must be empty, or given back by #scene_list_deinit.
 * @param settings  How scenes are loaded.
 * @param event  SDL event, registered, that tells of news.
 * @param path  A scene file: its folder is listed.
 * @return false if no thread could be started.
 */
bool scene_list_start(SceneList *list, const ViewSettings *settings, uint32_t event,
                      const char *path);

/** Tells the thread to end, and does not wait for it. */
void scene_list_request_stop(SceneList *list);

/** Gives a list back. Waits for its thread: at most as long as it takes to make a model's tree.
 *  @param[in,out] list The list, begun or not. */
void scene_list_deinit(SceneList *list);

/** @return Whether a list is begun and its thread at work. */
bool scene_list_is_busy(const SceneList *list);

/** Keeps the thread from changing the list, until #scene_list_unlock. */
void scene_list_lock(SceneList *list);

/** Lets the thread change the list again. */
void scene_list_unlock(SceneList *list);

#endif
