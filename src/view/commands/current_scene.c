/**
 * @file
 * @brief Loading scenes while the window stays open.
 *
 * A thread loads a scene; meanwhile keys and mouse move the scene on screen. The scene of a new
 * time is requested when the previous one is on screen, so a slow machine shows fewer pictures per
 * second while the time runs as fast. A faulty scene leaves the previous one on screen, with its
 * error.
 */
#include "view/commands/current_scene.h"

#include "base/scene_name.h"

#include <string.h>

/** Minimum seconds from one request to the next: a frame of a 60 Hz screen. */
static const double REQUEST_INTERVAL = 0.016;

/** @return When the scene's file was written; zero: it has none. */
static FileStamp file_stamp(const App *app) {
    struct stat info;
    if (strcmp(app->source.path, "-") == 0 || stat(app->source.path, &info) != 0) {
        return (FileStamp){0};
    }
    return (FileStamp){info.st_mtim, info.st_size, info.st_ino};
}

/** @return Whether the scene's file has been written since. */
static bool is_written_since(const App *app, FileStamp known) {
    FileStamp now = file_stamp(app);
    return now.time.tv_sec != known.time.tv_sec || now.time.tv_nsec != known.time.tv_nsec ||
           now.size != known.size || now.inode != known.inode;
}

bool current_scene_is_outdated(const App *app) {
    return is_written_since(app, app->source.shown_stamp);
}

void current_scene_file_written(App *app) {
    // Only values in it have changed: the scene on screen still stands at the same lines.
    app->source.stamp = app->source.shown_stamp = file_stamp(app);
    current_scene_reload(app);
}

/** Sets the scene's file, name and watch. */
static void set_path(App *app, const char *path) {
    scene_name_from_path(path, app->source.name, sizeof app->source.name);
    for (int is_french = 0; is_french < LANGUAGE_COUNT; is_french++) {
        char *label = app->source.labels[is_french];
        SDL_strlcpy(label, app->source.name, SCENE_NAME_SIZE);
        if (strcmp(path, "-") != 0) {
            scene_title_read_name(path, is_french, label, SCENE_NAME_SIZE);
        }
    }
    SDL_strlcpy(app->source.path, path, sizeof app->source.path);
    app->source.stamp = app->source.requested_stamp = app->source.shown_stamp = file_stamp(app);
    if (app->settings->load && strcmp(path, "-") != 0) {
        file_watcher_watch(&app->source.watcher, path);
    }
}

void current_scene_begin(App *app) {
    file_watcher_start(&app->source.watcher, app->first_event + EVENT_FILE_CHANGED);
    set_path(app, app->settings->path);
}

void current_scene_reload(App *app) {
    app->source.is_file_changed = true;
}

void current_scene_on_file_event(App *app) {
    if (is_written_since(app, app->source.stamp)) {
        // What the author writes counts, not what was tried in the window before.
        app->source.stamp = file_stamp(app);
        edit_history_clear(&app->edits);
        view_history_on_edits_cleared(&app->moves);
    }
    current_scene_reload(app);
}

void current_scene_open(App *app, const char *path) {
    if (app->settings->load) {
        SDL_strlcpy(app->source.next_path, path, sizeof app->source.next_path);
    }
}

bool current_scene_is_locked(App *app) {
    bool is_locked = app_is_playing(app) || app_is_recording(app);
    if (is_locked) {
        app_set_status(app, "a lesson keeps to its scene");
    }
    return is_locked;
}

void current_scene_browse(App *app) {
    if (current_scene_is_locked(app)) {
        return;
    }
    if (!app->settings->preview || !app->window.gui ||
        !browser_open(&app->window.browser, app->settings,
                      app->first_event + EVENT_SCENE_LIST_CHANGED, app->source.path)) {
        app_set_status(app, "no list of scenes can be shown");
    }
    window_present(&app->window);
}

void current_scene_repeat_error(App *app) {
    if (app->source.has_load_error && app->source.failed_path[0] != '\0') {
        current_scene_open(app, app->source.failed_path);
    } else if (app->source.has_load_error) {
        current_scene_reload(app);
    }
}

/** Takes the loaded scene's view as home view, and applies what the user moved unless it is another
 *  scene. @return false without memory; nothing is changed then. */
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

/** Replaces the renderers. A viewport that was opened since the request gets its own next.
 *  @param[in,out] load The scene and its renderers. */
static void replace_renderers(Window *window, SceneLoad *load) {
    window->base_settings = load->base_settings;
    window->own_settings = load->own_settings;
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        SceneLoadViewport *target = &load->viewports[i];
        if (target->renderer && window->viewports[i].renderer) {
            viewport_set_renderer(&window->viewports[i], target->renderer, &target->settings);
            ray_view_on_renderer_changed(&window->ray_view);
        } else {
            renderer_destroy(target->renderer);
            window->viewports[i].needs_new_renderer = true;
        }
    }
}

/** Replaces the scene on screen. @param[in,out] load The scene and its renderers; ownership passes.
 *  @return false without memory; nothing is changed then. */
static bool replace_scene(App *app, SceneLoad *load, Error *error) {
    if (!transfer_view_state(app, load, error)) {
        scene_load_deinit(load);
        return false;
    }
    if (load->path[0] != '\0') {
        window_forget_changes(&app->window);
    }
    replace_renderers(&app->window, load);
    scene_destroy(app->source.owned);
    app->scene = app->source.owned = load->scene;
    app->selected_light = app->selected_light < app->scene->light_count ? app->selected_light : 0;
    app->scene_time = load->time;
    app_sync_window(app);
    if (load->path[0] != '\0') {
        set_path(app, load->lesson ? load->lesson->scene : load->path);
        edit_history_clear(&app->edits);
        view_history_clear(&app->moves);
        app->source.requested_revision = app->edits.revision;
        app->window.object_inspector = (ObjectInspector){0};
        app->timeline = (Timeline){.time = load->time};
    }
    app->source.shown_revision = app->source.requested_revision;
    if (load->lesson) {
        lesson_destroy(app->source.lesson);
        app->source.lesson = load->lesson;
        SDL_strlcpy(app->source.lesson_path, load->path, sizeof app->source.lesson_path);
    }
    app->source.has_load_error = false;
    app->source.shown_stamp = app->source.requested_stamp;
    app_on_view_changed(app);
    if (load->path[0] != '\0' || load->force_reload) {
        app_show_notes(app);
    }
    return true;
}

/** Shows the requested scene if it is loaded and the previous picture is on screen. @param[out]
 * error Error of the loaded scene. @return Whether there was no error. */
static bool accept_loaded_scene(App *app, Error *error) {
    SceneLoad load;
    if (!window_is_ready(&app->window) || !scene_loader_poll(&app->source.loader, &load)) {
        return true;
    }
    bool is_complete = scene_load_is_complete(&load);
    app->source.shown_revision = app->source.requested_revision;
    if (is_complete && replace_scene(app, &load, error)) {
        return true;
    }
    if (!is_complete) {
        if (load.force_reload) {
            app->source.requested_stamp = (FileStamp){0};
        }
        *error = load.error;
        scene_load_deinit(&load);
        window_request_new_renderers(&app->window);
    }
    app->source.has_load_error = true;
    SDL_strlcpy(app->source.failed_path, load.path, sizeof app->source.failed_path);
    app->timeline = (Timeline){.time = app->scene_time};
    return false;
}

/** @return Whether a scene other than the one on screen is wanted. */
static bool is_load_wanted(const App *app) {
    bool is_time_changed = app_is_animated(app) && app_scene_time(app) != app->scene_time;
    bool is_edited = app->settings->load && app->source.requested_revision != app->edits.revision;
    return is_edited || is_time_changed || app->source.is_file_changed ||
           app->source.next_path[0] != '\0';
}

/** Requests the scene that is wanted. @return false if the loader's thread cannot start. */
static bool request_scene(App *app, double now, Error *error) {
    bool is_other = app->source.next_path[0] != '\0';
    SceneOverride overrides[SCENE_OVERRIDES_MAXIMUM];
    size_t override_count = is_other ? 0 : edit_history_overrides(&app->edits, overrides);
    ViewRequest request = {.path = is_other ? app->source.next_path : NULL,
                           .time = is_other ? 0 : app_scene_time(app),
                           .force_reload = app->source.is_file_changed,
                           .is_lesson_over = !app->player.lesson,
                           .overrides = overrides,
                           .override_count = override_count};
    SceneLoadViewport viewports[SCENE_LOAD_VIEWPORTS] = {0};
    for (size_t i = 0; i < window_viewport_count(&app->window); i++) {
        Viewport *viewport = &app->window.viewports[i];
        viewports[i] = (SceneLoadViewport){.reuse_from = viewport->renderer};
        if (!is_other) { // Another scene begins with its own settings.
            viewports[i].overrides = viewport->overrides;
        }
        viewport->needs_new_renderer = false;
    }
    if (request.force_reload) {
        app->source.requested_stamp = file_stamp(app); // Before it is read: it may be written now.
    }
    bool is_requested = scene_loader_request(&app->source.loader, &request, viewports, error);
    app->source.next_load_time = now + REQUEST_INTERVAL;
    app->source.requested_revision = app->edits.revision;
    app->source.is_file_changed = false;
    app->source.next_path[0] = '\0';
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
    bool is_wanted = (app_is_animated(app) && app->timeline.is_running) || is_load_wanted(app);
    // The scene may have been loaded before the previous picture was on screen; no event follows.
    if (scene_loader_has_result(&app->source.loader) && window_is_ready(&app->window)) {
        return 0;
    }
    if (!is_wanted || app->window.is_hidden || scene_loader_is_busy(&app->source.loader)) {
        return WINDOW_NO_TIMEOUT;
    }
    return fmax(0, app->source.next_load_time - now);
}

void current_scene_end(App *app) {
    file_watcher_stop(&app->source.watcher);
    scene_loader_stop(&app->source.loader);
    scene_destroy(app->source.owned);
    lesson_destroy(app->source.lesson);
}
