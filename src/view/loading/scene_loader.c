/**
 * @file
 * @brief Loading scenes in a thread.
 */
#include "view/loading/scene_loader.h"

#include "render/ray_stack.h"

#include <SDL.h>
#include <string.h>

bool scene_load_is_complete(const SceneLoad *load) {
    bool is_complete = load->scene != NULL;
    for (size_t i = 0; i < SCENE_LOAD_VIEWPORTS; i++) {
        const SceneLoadViewport *viewport = &load->viewports[i];
        is_complete = is_complete && (viewport->renderer || !viewport->reuse_from);
    }
    return is_complete;
}

void scene_load_deinit(SceneLoad *load) {
    for (size_t i = 0; i < SCENE_LOAD_VIEWPORTS; i++) {
        renderer_destroy(load->viewports[i].renderer);
        load->viewports[i].renderer = NULL;
    }
    scene_destroy(load->scene);
    lesson_destroy(load->lesson);
    load->scene = NULL;
    load->lesson = NULL;
}

/** Creates a renderer of the loaded scene. */
static void create_viewport_renderer(SceneLoad *load, SceneLoadViewport *viewport) {
    viewport->settings = load->base_settings;
    settings_override_apply(&viewport->overrides, &viewport->settings);
    viewport->renderer = renderer_create_reusing(viewport->reuse_from, load->scene,
                                                 &viewport->settings, &load->error);
}

/** Loads a scene and creates its renderers. The overrides stay as long as there is no result.
 * @param[in,out] load The request, then the result. */
static void load_scene(SceneLoader *loader, SceneLoad *load) {
    const ViewSettings *settings = loader->settings;
    const ViewRequest request = {.path = load->path[0] ? load->path : NULL,
                                 .time = load->time,
                                 .force_reload = load->force_reload,
                                 .overrides = loader->overrides,
                                 .override_count = loader->override_count};
    load->scene =
        settings->load(settings->loader_context, &request, &loader->should_stop,
                       &load->base_settings, &load->own_settings, &load->lesson, &load->error);
    if (load->is_lesson_over && !load->lesson) {
        load->base_settings = load->own_settings;
    }
    load->time = load->lesson ? load->lesson->initial_settings.time : load->time;
    for (size_t i = 0; load->scene && i < SCENE_LOAD_VIEWPORTS; i++) {
        if (load->viewports[i].reuse_from) {
            create_viewport_renderer(load, &load->viewports[i]);
        }
    }
}

/** Answers requests, as a thread. @return NULL */
static void *scene_loader_main(void *context) {
    SceneLoader *loader = context;
    pthread_mutex_lock(&loader->mutex);
    while (!atomic_load(&loader->should_stop)) {
        if (!loader->has_request) {
            pthread_cond_wait(&loader->condition, &loader->mutex);
            continue;
        }
        SceneLoad load = loader->load;
        pthread_mutex_unlock(&loader->mutex);
        load_scene(loader, &load);
        pthread_mutex_lock(&loader->mutex);
        loader->load = load;
        loader->has_request = false;
        loader->has_result = true;
        SDL_Event event = {.type = loader->event};
        SDL_PushEvent(&event);
    }
    pthread_mutex_unlock(&loader->mutex);
    return NULL;
}

/** Starts the thread, once. @return Whether it runs. */
static bool scene_loader_start(SceneLoader *loader, Error *error) {
    if (!loader->is_started) {
        pthread_mutex_init(&loader->mutex, NULL);
        pthread_cond_init(&loader->condition, NULL);
        int code = ray_thread_create(&loader->thread, scene_loader_main, loader);
        if (code != 0) {
            pthread_cond_destroy(&loader->condition);
            pthread_mutex_destroy(&loader->mutex);
            return error_set(error, STATUS_FAILED, "cannot start a thread: %s",
                             error_errno_text(code));
        }
        loader->is_started = true;
    }
    return true;
}

bool scene_loader_request(SceneLoader *loader, const ViewRequest *request,
                          const SceneLoadViewport viewports[SCENE_LOAD_VIEWPORTS], Error *error) {
    if (!scene_loader_start(loader, error)) {
        return false;
    }
    pthread_mutex_lock(&loader->mutex);
    SceneLoad *load = &loader->load;
    *load = (SceneLoad){.time = request->time,
                        .force_reload = request->force_reload,
                        .is_lesson_over = request->is_lesson_over};
    SDL_strlcpy(load->path, request->path ? request->path : "", sizeof load->path);
    memcpy(load->viewports, viewports, sizeof load->viewports);
    loader->override_count = request->override_count;
    if (request->override_count > 0) {
        memcpy(loader->overrides, request->overrides,
               request->override_count * sizeof *request->overrides);
    }
    loader->has_request = true;
    pthread_cond_signal(&loader->condition);
    pthread_mutex_unlock(&loader->mutex);
    return true;
}

bool scene_loader_has_result(SceneLoader *loader) {
    if (!loader->is_started) {
        return false;
    }
    pthread_mutex_lock(&loader->mutex);
    bool is_there = loader->has_result;
    pthread_mutex_unlock(&loader->mutex);
    return is_there;
}

bool scene_loader_is_busy(SceneLoader *loader) {
    if (!loader->is_started) {
        return false;
    }
    pthread_mutex_lock(&loader->mutex);
    bool is_busy = loader->has_request || loader->has_result;
    pthread_mutex_unlock(&loader->mutex);
    return is_busy;
}

bool scene_loader_poll(SceneLoader *loader, SceneLoad *load) {
    if (!loader->is_started) {
        return false;
    }
    pthread_mutex_lock(&loader->mutex);
    bool is_there = loader->has_result;
    if (is_there) {
        *load = loader->load;
        loader->has_result = false;
    }
    pthread_mutex_unlock(&loader->mutex);
    return is_there;
}

void scene_loader_stop(SceneLoader *loader) {
    if (!loader->is_started) {
        return;
    }
    pthread_mutex_lock(&loader->mutex);
    atomic_store(&loader->should_stop, true);
    pthread_cond_signal(&loader->condition);
    pthread_mutex_unlock(&loader->mutex);
    pthread_join(loader->thread, NULL);
    if (loader->has_result) {
        scene_load_deinit(&loader->load);
    }
    pthread_cond_destroy(&loader->condition);
    pthread_mutex_destroy(&loader->mutex);
    loader->is_started = false;
}
