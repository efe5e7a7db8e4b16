/**
 * @file
 * @brief A thread that makes another scene, or the same of another time, and what draws it, while
 *        the window lives on.
 */
#ifndef DIOPTRE_VIEW_LOADING_SCENE_LOADER_H
#define DIOPTRE_VIEW_LOADING_SCENE_LOADER_H

#include "dioptre/view.h"
#include "view/state/settings_override.h"

#include <limits.h>
#include <pthread.h>

/** Pictures of a scene, at most. */
enum { SCENE_LOAD_VIEWPORTS = 2 };

/** What draws a picture of it. */
typedef struct SceneLoadViewport {
    const Renderer *reuse_from; /**< What draws the scene before; NULL: there is no such picture. */
    SettingsOverride overrides; /**< What the user has changed of how it is drawn. */
    RenderSettings settings;    /**< How it is drawn then. */
    Renderer *renderer;         /**< What draws it; NULL: it could not be made, or is not wanted. */
} SceneLoadViewport;

/** Another scene, or the same of another time. */
typedef struct SceneLoad {
    char path[PATH_MAX];          /**< Its file; empty: that of the scene before. */
    double time;                  /**< Its time, seconds. */
    bool force_reload;            /**< Whether its files may have changed. */
    Scene *scene;                 /**< The scene; NULL: it could not be made. */
    RenderSettings base_settings; /**< How it is to be drawn, but for what the user has changed. */
    SceneLoadViewport
        viewports[SCENE_LOAD_VIEWPORTS]; /**< What draws it; the first is always wanted. */
    Error error;                         /**< Why not. */
} SceneLoad;

/** The thread, and what it is asked. Starts as `{.settings = ...}`. */
typedef struct SceneLoader {
    const ViewSettings *settings; /**< How scenes are loaded and drawn. */
    uint32_t event;               /**< SDL event, registered, that tells of an answer. */
    bool is_started;              /**< Whether the thread runs. */
    pthread_t thread;             /**< The thread. */
    pthread_mutex_t mutex;        /**< Guards what follows. */
    pthread_cond_t condition;     /**< Told when there is something to do. */
    bool has_request;             /**< Whether there is a question that was not answered yet. */
    bool has_result;              /**< Whether there is an answer that was not taken yet. */
    SceneLoad load;               /**< The question's time, then the answer. */
    atomic_bool should_stop;      /**< Whether to end, at once. */
} SceneLoader;

/**
 * Asks for a scene. The first question starts the thread.
 * @param[in,out] loader  The thread; every question before was answered, and the answer taken.
 * @param viewports  What of it is to be drawn; copied. The new renderers share with the former ones
 *         what both need: those must stay there until the answer is.
 * @return false if there is no thread to ask.
 */
bool scene_loader_request(SceneLoader *loader, const ViewRequest *request,
                          const SceneLoadViewport viewports[SCENE_LOAD_VIEWPORTS], Error *error);

/** @return Whether there is a question or an answer that was not taken. */
bool scene_loader_is_busy(SceneLoader *loader);

/** @return Whether there is an answer that was not taken. */
bool scene_loader_has_result(SceneLoader *loader);

/**
 * Takes an answer.
 * @param[out] load  The answer, the caller's to give back.
 * @return false while there is none.
 */
bool scene_loader_poll(SceneLoader *loader, SceneLoad *load);

/** @return Whether all that was wanted is there. */
bool scene_load_is_complete(const SceneLoad *load);

/** Gives scene and renderers back. */
void scene_load_deinit(SceneLoad *load);

/** Ends the thread, whatever it does. @param[in,out] loader The thread, started or not. */
void scene_loader_stop(SceneLoader *loader);

#endif
