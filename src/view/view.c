/**
 * @file
 * @brief The window: opening it, its event loop, closing it.
 *
 * The loop sleeps until an event comes. A pass of the picture is an event too, and so is Ctrl-C,
 * so nothing is ever polled for; only held keys make it wake up by itself, once a frame.
 */
#include "dioptre/view.h"

#include "base/json.h"
#include "view/app.h"
#include "view/commands/snapshot_command.h"
#include "view/commands/time_control.h"
#include "view/input/input.h"
#include "view/input/signal_thread.h"
#include "view/loading/current_scene.h"
#include "view/window/title.h"
#include "view/window/video.h"

#include <libintl.h>
#include <stdarg.h>
#include <string.h>

/** Seconds from one move of held keys to the next: a frame of a common screen. */
static const double MOVE_INTERVAL = 0.016;
/** Seconds that a title stands at least while a picture is drawn, so that it can be read. */
static const double TITLE_INTERVAL = 0.25;

void app_set_status(App *app, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(app->status_text, sizeof app->status_text, gettext(format), arguments);
    va_end(arguments);
    app->next_title_time = 0;
}

void app_clear_status(App *app) {
    app->status_text[0] = '\0';
    app->next_title_time = 0;
}

void app_on_view_changed(App *app) {
    window_invalidate(&app->window);
    if (!app->wants_snapshot) {
        app->status_text[0] = '\0';
    }
    if (!app->has_load_error) {
        window_set_notice(&app->window, "");
    }
}

void app_report_error(App *app, const Error *error) {
    fprintf(stderr, "dioptre: %s\n", error->message);
    app_set_status(app, "%.*s", STATUS_TEXT_SIZE - 1, error->message);
    window_set_notice(&app->window, error->message);
}

/** Moves things as far as the keys were held. */
static void apply_held_keys(App *app, double now) {
    if (now >= app->next_move_time && window_is_ready(&app->window) &&
        held_keys_is_active(&app->held_keys)) {
        Movement light, camera;
        held_keys_consume(&app->held_keys, now, &light, &camera);
        app_move(app, light, camera);
        app->next_move_time = now + MOVE_INTERVAL;
    }
}

/** Takes a snapshot if one is wanted and the picture is finished, with nothing on the move. */
static void take_pending_snapshot(App *app) {
    bool is_settled = window_is_finished(&app->window) && !held_keys_is_active(&app->held_keys) &&
                      time_control_is_settled(app);
    if (app->wants_snapshot && is_settled) {
        Error error = {0};
        app->wants_snapshot = false;
        if (!snapshot_take(app, app->settings->snapshot_dir, app->name, &error)) {
            app_report_error(app, &error);
        }
    }
}

/** Brings the title up to date. */
static void update_title(App *app, double now) {
    const Window *window = &app->window;
    const Viewport *viewport = &window->viewports[0];
    if (now < app->next_title_time && !window_is_finished(window)) {
        return;
    }
    TitleContent content = {.name = app->name,
                            .width = viewport->width,
                            .height = viewport->height,
                            .report = window->first_present_time > 0 ? &viewport->report : NULL,
                            .time = app->scene->is_time_dependent ? &app->scene_time : NULL,
                            .is_running = app->timeline.is_running,
                            .is_recording = recorder_is_active(app),
                            .light = app->selected_light,
                            .light_count = app->scene->light_count,
                            .status_text = app->status_text};
    char title[TITLE_SIZE];
    title_write(&content, title);
    if (strcmp(title, SDL_GetWindowTitle(window->sdl.window)) != 0) {
        SDL_SetWindowTitle(window->sdl.window, title);
    }
    app->next_title_time = now + TITLE_INTERVAL;
}

/** Sleeps until there is something to do. @return Whether one came. */
static bool wait_for_event(App *app, double now, SDL_Event *event) {
    double delay = fmin(window_timeout(&app->window, now), current_scene_timeout(app, now));
    if (held_keys_is_active(&app->held_keys) && window_is_ready(&app->window)) {
        delay = fmin(delay, fmax(0, app->next_move_time - now));
    }
    delay = fmin(delay, fmin(player_timeout(app, now), recorder_timeout(app, now)));
    if (isinf(delay)) {
        return SDL_WaitEvent(event);
    }
    return SDL_WaitEventTimeout(event, (int)ceil(delay * 1000));
}

/** Does one round: moves, draws, shows, and sleeps. */
static void run_frame(App *app) {
    Error error = {0};
    apply_held_keys(app, clock_now_seconds());
    player_update(app, clock_now_seconds());
    recorder_update(app, clock_now_seconds());
    if (!current_scene_update(app, clock_now_seconds(), &error) &&
        error.status != STATUS_INTERRUPTED) {
        app_report_error(app, &error);
    }
    if (!scene_loader_is_busy(&app->loader) &&
        !window_update_renderers(&app->window, app->scene, &error)) {
        app_report_error(app, &error);
    }
    if (!window_update(&app->window, app->scene, clock_now_seconds(), &error)) {
        app_report_error(app, &error);
    }
    take_pending_snapshot(app);
    if (!player_capture(app, &error)) {
        app_report_error(app, &error);
    }
    update_title(app, clock_now_seconds());
    SDL_Event event;
    bool is_event = !app->should_quit && wait_for_event(app, clock_now_seconds(), &event);
    while (is_event && !app->should_quit) {
        input_handle_event(app, &event);
        is_event = SDL_PollEvent(&event);
    }
}

/** Prints what was measured, as one line of JSON. */
static void print_timing(App *app) {
    LatencySummary summary = latency_summary(&app->window.latency);
    double first = app->window.first_present_time - app->settings->launch_time;
    JsonWriter json = {.stream = stdout};
    json_object_begin(&json, NULL);
    json_decimal(&json, "first_picture_ms", first * 1e3, 1);
    json_count(&json, "keys", summary.count);
    json_decimal(&json, "key_to_picture_ms_median", summary.median * 1e3, 1);
    json_decimal(&json, "key_to_picture_ms_worst", summary.worst * 1e3, 1);
    json_line_end(&json);
    fflush(stdout);
}

/**
 * Opens the window, lives its life and closes it.
 * @param[in,out] app  The view, with SDL up.
 * @param stop  The window closes once this is true; may be NULL.
 * @return What the program should end with.
 */
static Status run_event_loop(App *app, const atomic_bool *stop, SignalThread *signal_thread,
                             Error *error) {
    const ViewSettings *settings = app->settings;
    app->first_event = SDL_RegisterEvents(EVENT_COUNT);
    app->loader.event = app->first_event + EVENT_SCENE_LOADED;
    signal_thread_start(signal_thread, app->first_event + EVENT_SIGNAL);
    current_scene_begin(app);
    if (!view_state_init(&app->home_view, app->scene, error) ||
        !window_open(&app->window, app->scene, &settings->render, app->name,
                     app->first_event + EVENT_PASS_FINISHED, error)) {
        return error->status;
    }
    player_begin(app);
    while (!app->should_quit) {
        run_frame(app);
        if (stop && atomic_load(stop)) {
            app->should_quit = true;
            app->exit_status = STATUS_INTERRUPTED;
        }
    }
    if (!recorder_end(app, error)) {
        app->exit_status = error->status;
    }
    if (app->wants_snapshot) {
        fprintf(stderr, gettext("dioptre: no snapshot: the picture was not finished\n"));
    }
    if (settings->prints_timing) {
        print_timing(app);
    }
    return app->exit_status;
}

const char *const *view_actions(int *move_count) {
    *move_count = ACTION_MOVE_COUNT;
    return action_names();
}

bool view_is_possible(void) {
    bool is_possible = video_start(NULL);
    SDL_Quit();
    return is_possible;
}

Status view_run(Scene *scene, const ViewSettings *settings, const atomic_bool *stop, Error *error) {
    App app = {.settings = settings,
               .scene = scene,
               .held_keys = {.speed = 1},
               .timeline = {.time = settings->initial_time},
               .scene_time = settings->initial_time,
               .loader = {.settings = settings}};
    app.window.help.by_letter = settings->keys_by_letter;
    Status status = STATUS_FAILED;
    SignalThread signal_thread;
    signal_thread_block(&signal_thread);
    if (video_start(error)) {
        status = run_event_loop(&app, stop, &signal_thread, error);
        player_end(&app);
        current_scene_end(
            &app); // The scene that it may still make shares with what the stage draws.
        window_close(&app.window);
    }
    signal_thread_stop(&signal_thread);
    SDL_Quit();
    view_state_deinit(&app.home_view);
    return status;
}
