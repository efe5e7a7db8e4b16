/**
 * @file
 * @brief An open window on a scene file of a folder of its own, without a screen: SDL's dummy
 * driver. What the window does in its loop is done by settle().
 */
#ifndef DIOPTRE_TESTS_APP_WINDOW_H
#define DIOPTRE_TESTS_APP_WINDOW_H

#include "fixtures.h"
#include "fontconfig_leak.h"

#include "base/clock.h"
#include "dioptre/script.h"
#include "view/commands/commands.h"
#include "view/commands/current_scene.h"
#include "view/commands/edits.h"
#include "view/input/input.h"

/** What a test works with. */
typedef struct AppWindow {
    App app;               /**< The open window. */
    ViewSettings settings; /**< How it was opened. */
    void *files;           /**< The #Fixture with the folder of the scene file, and of copies. */
    char path[PATH_MAX];   /**< The scene file. */
    char loaded[PATH_MAX]; /**< The file that was loaded last. */
    int own_depth;         /**< Depth of its scene without a lesson; 0: as with it. */
} AppWindow;

/** The only window: SDL has one video driver. */
static AppWindow opened;

/** Writes a text file of the folder. @return Its path, until the next file is named. */
static const char *write_text(const char *name, const char *text) {
    const char *path = fixture_path(&opened.files, name);
    write_file(path, text, strlen(text));
    return path;
}

/** @return The text of a file of the folder, until the next call. */
static inline const char *file_text(const char *name) {
    static char text[4096];
    FILE *file = fopen(fixture_path(&opened.files, name), "re");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    return text;
}

/** @return The folder of the scene file. */
static const char *app_folder(void) {
    return ((const Fixture *)opened.files)->folder;
}

/** Loads the scene. See #ViewLoader. */
static Scene *load(void *context, const ViewRequest *request, const atomic_bool *stop,
                   RenderSettings *render, RenderSettings *own, Lesson **lesson, Error *error) {
    const ScriptRequest script = {.path = request->path ? request->path : opened.loaded,
                                  .time_limit = SCRIPT_TIME_LIMIT,
                                  .memory_limit = SCRIPT_MEMORY_LIMIT,
                                  .overrides = request->overrides,
                                  .override_count = request->override_count};
    (void)context, (void)stop;
    *lesson = NULL;
    *render = *own = opened.settings.render;
    own->trace.depth = opened.own_depth > 0 ? opened.own_depth : own->trace.depth;
    Scene *scene = script_load(&script, error);
    if (scene && request->path) {
        SDL_strlcpy(opened.loaded, request->path, sizeof opened.loaded);
    }
    return scene;
}

/** Loads what is asked for, and waits until it is on screen. @return Whether it could be loaded. */
static bool settle(void) {
    App *app = &opened.app;
    Error error = {0};
    double start = clock_now_seconds();
    bool is_good = true;
    do {
        SDL_Event event;
        is_good = current_scene_update(app, clock_now_seconds(), &error) && is_good;
        assert_true(scene_loader_is_busy(&app->source.loader) ||
                    window_update_renderers(&app->window, app->scene, &error));
        assert_true(window_update(&app->window, app->scene, clock_now_seconds(), &error));
        while (SDL_PollEvent(&event)) {
            input_handle_event(app, &event);
        }
        SDL_Delay(1);
        assert_true(clock_now_seconds() - start < 60);
    } while (!window_is_ready(&app->window) || scene_loader_is_busy(&app->source.loader) ||
             scene_loader_has_result(&app->source.loader) || app->source.is_file_changed ||
             app->source.requested_revision != app->edits.revision ||
             app->source.next_path[0] != '\0');
    return is_good;
}

/** Opens a window. @param text The scene file. @param part Another file, part.lua. @return 0 if it
 *  is open. */
static int open_app_window(const char *text, const char *part) {
    App *app = &opened.app;
    Error error = {0};
    memset(&opened, 0, sizeof opened);
    setenv("SDL_VIDEODRIVER", "dummy", 1);
    setenv("SDL_RENDER_DRIVER", "software", 1);
    if (fixture_set_up(&opened.files) != 0) {
        return -1;
    }
    write_text("part.lua", part);
    strcpy(opened.path, write_text("scene.lua", text));
    opened.settings = (ViewSettings){.render = {.engine = engine_find("f64x1", &error),
                                                .threads = 1,
                                                .width = 64,
                                                .height = 48,
                                                .samples = 1,
                                                .trace = {.depth = 2, .epsilon = 1e-4}},
                                     .path = opened.path,
                                     .snapshot_dir = app_folder(),
                                     .load = load};
    RenderSettings render;
    Lesson *lesson;
    Scene *scene =
        load(NULL, &(ViewRequest){.path = opened.path}, NULL, &render, &render, &lesson, &error);
    if (!scene) {
        print_error("%s\n", error.message);
        return -1;
    }
    *app = (App){.settings = &opened.settings,
                 .commands = command_table,
                 .scene = scene,
                 .input = {.held_keys = {.speed = 1}},
                 .source = {.loader = {.settings = &opened.settings}}};
    app->source.owned = scene;
    app->window.help.commands = command_table;
    app->first_event = SDL_RegisterEvents(EVENT_COUNT);
    app->source.loader.event = app->first_event + EVENT_SCENE_LOADED;
    if (!video_start(&error) || !view_state_init(&app->home_view, scene, &error) ||
        !window_open(&app->window, scene, &opened.settings.render, "scene",
                     app->first_event + EVENT_PASS_FINISHED, &error)) {
        print_error("%s\n", error.message);
        return -1;
    }
    current_scene_begin(app);
    app_sync_window(app);
    return settle() ? 0 : -1;
}

/** Closes the window, and removes its folder. @return 0 */
static int close_app_window(void **state) {
    (void)state;
    App *app = &opened.app;
    current_scene_end(app);
    window_close(&app->window);
    SDL_Quit();
    view_state_deinit(&app->home_view);
    edit_history_deinit(&app->edits);
    view_history_clear(&app->moves);
    return fixture_tear_down(&opened.files);
}

/** Fails unless the newest status has some words. */
static void assert_status(const char *words) {
    if (!strstr(opened.app.title.status_text, words)) {
        fail_msg("'%s' has no '%s'", opened.app.title.status_text, words);
    }
}

/** Runs a command as its key does. */
static inline void run(const char *name) {
    const Command *command = command_find(command_table, name);
    assert_non_null(command);
    command_issue(&opened.app, command, clock_now_seconds());
}

#endif
