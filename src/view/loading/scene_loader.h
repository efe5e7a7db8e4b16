/**
 * @file
 * @brief A thread that loads another scene, or the same at another time, with its renderers.
 */
#ifndef DIOPTRE_VIEW_LOADING_SCENE_LOADER_H
#define DIOPTRE_VIEW_LOADING_SCENE_LOADER_H

#include "dioptre/view.h"
#include "view/state/settings_override.h"

#include <limits.h>
#include <pthread.h>

/** Most viewports of a scene. */
enum { SCENE_LOAD_VIEWPORTS = 2 };

/** A viewport of the loaded scene. */
typedef struct SceneLoadViewport {
    const Renderer
        *reuse_from; /**< Renderer of the previous scene; NULL: the viewport is closed. */
    SettingsOverride overrides; /**< What the user has changed of the settings. */
    RenderSettings settings;    /**< Settings of #renderer. */
    Renderer *renderer;         /**< The renderer; NULL: an error, or the viewport is closed. */
} SceneLoadViewport;

/** A request, then its result. */
typedef struct SceneLoad {
    char path[PATH_MAX];          /**< File of the scene or lesson; empty: the previous scene. */
    double time;                  /**< Its time, seconds. */
    bool force_reload;            /**< Whether its files may have changed. */
    bool is_lesson_over;          /**< See #ViewRequest.is_lesson_over. */
    Scene *scene;                 /**< The scene; NULL: an error. */
    Lesson *lesson;               /**< The lesson that #path is; NULL: it is a scene. */
    RenderSettings base_settings; /**< Settings without the user's changes. */
    RenderSettings own_settings;  /**< The same without those of a lesson. */
    SceneLoadViewport
        viewports[SCENE_LOAD_VIEWPORTS]; /**< Its viewports; the first is always open. */
    Error error;                         /**< The error. */
} SceneLoad;

/** The thread and its request. Starts as `{.settings = ...}`. */
typedef struct SceneLoader {
    const ViewSettings *settings; /**< How scenes are loaded. */
    uint32_t event;               /**< SDL event, registered, to send when a result is ready. */
    bool is_started;              /**< Whether the thread runs. */
    pthread_t thread;             /**< The thread. */
    pthread_mutex_t mutex;        /**< Locks the members below. */
    pthread_cond_t condition;     /**< Signalled for a request and for the end. */
    bool has_request;             /**< Whether there is a request without a result. */
    bool has_result;              /**< Whether there is a result that was not taken. */
    SceneLoad load;               /**< The request, then its result. */
    SceneOverride overrides[SCENE_OVERRIDES_MAXIMUM]; /**< Overrides of the request. */
    size_t override_count;                            /**< Their number. */
    atomic_bool should_stop;                          /**< Whether the thread should end. */
} SceneLoader;

/**
 * Requests a scene. The first request starts the thread.
 * @param[in,out] loader  Not busy.
 * @param viewports  The viewports; copied. New renderers share data with
 * #SceneLoadViewport.reuse_from, which must exist until the result is taken.
 * @return false if the thread cannot start.
 */
bool scene_loader_request(SceneLoader *loader, const ViewRequest *request,
                          const SceneLoadViewport viewports[SCENE_LOAD_VIEWPORTS], Error *error);

/** @return Whether there is a request, or a result that was not taken. */
bool scene_loader_is_busy(SceneLoader *loader);

/** @return Whether there is a result that was not taken. */
bool scene_loader_has_result(SceneLoader *loader);

/** Takes the result. @param[out] load The result, owned by the caller. @return false while there is
 * none. */
bool scene_loader_poll(SceneLoader *loader, SceneLoad *load);

/** @return Whether scene and renderers were all created. */
bool scene_load_is_complete(const SceneLoad *load);

/** Frees scene, lesson and renderers. */
void scene_load_deinit(SceneLoad *load);

/** Stops the thread, also in the middle of loading. */
void scene_loader_stop(SceneLoader *loader);

#endif
