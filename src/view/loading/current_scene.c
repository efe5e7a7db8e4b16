/**
 * @file
 * @brief Scenes come and go while the window stays.
 *
 * A scene file is run in a child of a thread of its own. Nobody waits for it: meanwhile keys and
 * mouse move what is on screen. A new time is asked for when the last answer is on screen, so on a
 * slow machine there are fewer pictures a second, and the time is as fast. A scene that cannot be
 * had leaves the one before on screen, with words over it.
 */
#include "view/loading/current_scene.h"

#include "base/scene_name.h"
#include "view/commands/time_control.h"

#include <string.h>

/** Seconds from one question to the next at least: a frame of a common screen. */
static const double REQUEST_INTERVAL = 0.016;

/** Goes by a file from now on. */
static void set_path(App *app, const char *path) {
    scene_name_from_path(path, app->name, sizeof app->name);
    SDL_strlcpy(app->path, path, sizeof app->path);
    if (app->settings->load && strcmp(path, "-") != 0) {
        file_watcher_watch(&app->watcher, path);
    }
}

void current_scene_begin(App *app) {
    file_watcher_start(&app->watcher, app->first_event + EVENT_FILE_CHANGED);
    set_path(app, app->settings->path);
}

void current_scene_reload(App *app) {
    app->is_file_changed = true;
}

void current_scene_open(App *app, const char *path) {
    if (app->settings->load) {
        SDL_strlcpy(app->next_path, path, sizeof app->next_path);
    }
}

void current_scene_repeat_error(App *app) {
    if (app->has_load_error && app->failed_path[0] != '\0') {
        current_scene_open(app, app->failed_path);
    } else if (app->has_load_error) {
        current_scene_reload(app);
    }
}

/** Keeps where camera and lights are, and puts back what the user has moved; in another scene,
 *  nothing was. @return false without memory; nothing is changed then. */
static bool transfer_view_state(App *app, const SceneLoad *load, Error *error) {
    if (load->path[0] == '\0') {
        return view_state_transfer(&app->home_view, app->scene, load->scene, error);
    }
    ViewState home_view;
    if (!view_state_init(&home_view, load->scene, error)) {
        return false;
    }
    view_state_deinit(&app->home_view);
    app->home_view = home_view;
    return true;
}

/** Draws another scene from now on. A picture that has come meanwhile is made for it next.
 *  @param[in,out] load The scene and its renderers. */
static void replace_renderers(Window *window, SceneLoad *load) {
    window->base_settings = load->base_settings;
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        SceneLoadViewport *target = &load->viewports[i];
        if (target->renderer && window->viewports[i].renderer) {
            viewport_set_renderer(&window->viewports[i], target->renderer, &target->settings);
            inspector_on_renderer_changed(&window->inspector);
        } else {
            renderer_destroy(target->renderer);
            window->viewports[i].needs_new_renderer = true;
        }
    }
}

/**
 * Puts a scene in the place of the one that is shown.
 * @param[in,out] load  The scene and its renderers; the view's from now on.
 * @return false without memory; nothing is changed then.
 */
static bool replace_scene(App *app, SceneLoad *load, Error *error) {
    if (!transfer_view_state(app, load, error)) {
        scene_load_deinit(load);
        return false;
    }
    replace_renderers(&app->window, load);
    scene_destroy(app->owned_scene);
    app->scene = app->owned_scene = load->scene;
    app->selected_light = app->selected_light < app->scene->light_count ? app->selected_light : 0;
    app->scene_time = load->time;
    if (load->path[0] != '\0') {
        set_path(app, load->path);
        app->timeline = (Timeline){.time = load->time};
    }
    app->has_load_error = false;
    app_on_view_changed(app);
    return true;
}

/**
 * Takes the scene that was asked for, if it is there and there is room for it on screen.
 * @param[out] error  What is wrong with it.
 * @return Whether all is well.
 */
static bool accept_loaded_scene(App *app, Error *error) {
    SceneLoad load;
    if (!window_is_ready(&app->window) || !scene_loader_poll(&app->loader, &load)) {
        return true;
    }
    bool is_complete = scene_load_is_complete(&load);
    if (is_complete && replace_scene(app, &load, error)) {
        return true;
    }
    if (!is_complete) {
        *error = load.error;
        scene_load_deinit(&load);
        window_request_new_renderers(&app->window);
    }
    app->has_load_error = true;
    SDL_strlcpy(app->failed_path, load.path, sizeof app->failed_path);
    app->timeline = (Timeline){.time = app->scene_time};
    return false;
}

/** @return Whether another scene is wanted than the one that is shown. */
static bool is_load_wanted(const App *app) {
    bool is_time_changed =
        time_control_is_animated(app) && time_control_scene_time(app) != app->scene_time;
    return is_time_changed || app->is_file_changed || app->next_path[0] != '\0';
}

/** Asks for the scene that is wanted. @return false if there is nobody to ask. */
static bool request_scene(App *app, double now, Error *error) {
    bool is_other = app->next_path[0] != '\0';
    ViewRequest request = {.path = is_other ? app->next_path : NULL,
                           .time = is_other ? 0 : time_control_scene_time(app),
                           .force_reload = app->is_file_changed};
    SceneLoadViewport viewports[SCENE_LOAD_VIEWPORTS] = {0};
    for (size_t i = 0; i < window_viewport_count(&app->window); i++) {
        Viewport *viewport = &app->window.viewports[i];
        viewports[i] =
            (SceneLoadViewport){.reuse_from = viewport->renderer, .overrides = viewport->overrides};
        viewport->needs_new_renderer = false;
    }
    bool is_requested = scene_loader_request(&app->loader, &request, viewports, error);
    app->next_load_time = now + REQUEST_INTERVAL;
    app->is_file_changed = false;
    app->next_path[0] = '\0';
    if (!is_requested) {
        app->timeline = (Timeline){.time = app->scene_time};
    }
    return is_requested;
}

bool current_scene_update(App *app, double now, Error *error) {
    bool ok = accept_loaded_scene(app, error);
    if (!ok || !is_load_wanted(app) || current_scene_timeout(app, now) > 0) {
        return ok;
    }
    return request_scene(app, now, error);
}

double current_scene_timeout(App *app, double now) {
    bool is_wanted =
        (time_control_is_animated(app) && app->timeline.is_running) || is_load_wanted(app);
    // An answer may have come while the picture before was not on screen yet: nothing tells again.
    if (scene_loader_has_result(&app->loader) && window_is_ready(&app->window)) {
        return 0;
    }
    if (!is_wanted || app->window.is_hidden || scene_loader_is_busy(&app->loader)) {
        return WINDOW_NO_TIMEOUT;
    }
    return fmax(0, app->next_load_time - now);
}

void current_scene_end(App *app) {
    file_watcher_stop(&app->watcher);
    scene_loader_stop(&app->loader);
    scene_destroy(app->owned_scene);
}
