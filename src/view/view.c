/**
 * @file
 * @brief Opening the window, its event loop, closing it.
 *
 * The loop sleeps until an event comes. A finished render pass is an event too, and so is Ctrl-C:
 * nothing is polled. Timeouts wake it only for held keys, a running time and a lesson's steps.
 */
#include "dioptre/view.h"

#include "base/json.h"
#include "base/language.h"
#include "view/app.h"
#include "view/commands/commands.h"
#include "view/commands/current_scene.h"
#include "view/commands/edits.h"
#include "view/commands/recorder.h"
#include "view/input/input.h"
#include "view/input/signal_thread.h"
#include "view/lesson/answer_file.h"
#include "view/lesson/player.h"

#include <libintl.h>
#include <string.h>

/** Seconds from one move of held keys to the next: a frame of a 60 Hz screen. */
static const double MOVE_INTERVAL = 0.016;
/** Width of a letter in the titles of usual window managers, screen units. */
enum { TITLE_LETTER_WIDTH = 8 };
/** Minimum seconds between two titles while a picture is drawn, so that they can be read. */
static const double TITLE_INTERVAL = 0.25;

/** Moves light and camera by the time that keys were held. */
static void apply_held_keys(App *app, double now) {
    if (now >= app->input.next_move_time && window_is_ready(&app->window) &&
        held_keys_is_active(&app->input.held_keys)) {
        Movement light, camera;
        held_keys_consume(&app->input.held_keys, now, &light, &camera);
        app_move(app, light, camera);
        app->input.next_move_time = now + MOVE_INTERVAL;
    }
}

/** Takes a requested snapshot once the picture is finished and nothing moves. */
static void take_pending_snapshot(App *app) {
    bool is_settled = window_is_finished(&app->window) &&
                      !held_keys_is_active(&app->input.held_keys) && app_is_time_settled(app);
    if (app->wants_snapshot && is_settled) {
        Error error = {0};
        app->wants_snapshot = false;
        if (!app_save_picture(app, app->settings->snapshot_dir, app->source.name, &error)) {
            app_report_error(app, &error);
        }
    }
}

/** Issues a command, as its key would; the key of a move goes up at once. @param continues Whether
 *  it belongs to the change before it. */
static void issue_requested(App *app, const Command *command, bool continues) {
    double now = clock_now_seconds();
    if (continues) {
        command_continue(app, command, now);
    } else {
        command_issue(app, command, now);
    }
    if (command_is_move(command)) {
        recorder_on_release(app, command, now);
        held_keys_release(&app->input.held_keys, command->move, now);
    }
}

/** Runs a command by its name, as its key would. @param name NULL: does nothing. @param continues
 *  Whether it belongs to the change before it; repetitions belong to the first one. */
static void run_command(App *app, const char *name, int repetitions, bool continues) {
    const Command *command = name ? command_find(app->commands, name) : NULL;
    for (int i = 0; command && i < repetitions; i++) {
        if (!player_handle_command(app, command)) {
            issue_requested(app, command, continues || i > 0);
        }
    }
}

/** Closes the list of scenes if its own button asks for it, or if what another button does would be
 *  hidden by it. @param command Name of the command of that button; NULL: none. */
static void close_covering_list(App *app, const char *command) {
    Browser *browser = &app->window.browser;
    bool is_covering = command && strcmp(command, "scenes") != 0 &&
                       strcmp(command, "lessons") != 0 && strcmp(command, "toolbar") != 0;
    if (browser->is_open && (browser->is_close_requested || is_covering)) {
        browser_close(browser);
        window_present(&app->window);
    }
    browser->is_close_requested = false;
}

/** Runs the command that a button, a list or a slider requests. */
static void run_requested_command(App *app) {
    Toolbar *toolbar = &app->window.toolbar;
    RayViewRequest *rays = &app->window.ray_view.request;
    close_covering_list(app, toolbar->command);
    run_command(app, toolbar->command, toolbar->repetitions, toolbar->continues);
    run_command(app, rays->command, 1, false);
    if (rays->has_ray && !app_is_playing(app)) {
        command_choose_ray(app, rays->ray);
    }
    if (app->window.browser.is_requested) {
        player_open_selected(app);
        window_present(&app->window);
    }
    // What frames in between have requested counted from a part of the change.
    toolbar->command = NULL;
    *rays = (RayViewRequest){0};
}

/** @return The name of what is shown: the title of the lesson, else the name of the scene. */
static const char *shown_name(const App *app) {
    const bool is_french = language_is_french();
    const Lesson *lesson = app->player.lesson;
    const char *title = lesson ? lesson_text_localized(&lesson->title, is_french) : "";
    return title[0] != '\0' ? title : app->source.labels[is_french];
}

/** Updates the title. */
static void update_title(App *app, double now) {
    const Window *window = &app->window;
    const Viewport *viewport = &window->viewports[0];
    if (now < app->title.next_update_time && !window_is_finished(window)) {
        return;
    }
    int window_width = 0;
    SDL_GetWindowSize(window->sdl.window, &window_width, NULL);
    // Times and rays of other settings would be read as those of the new ones.
    bool has_report = window->first_present_time > 0 && !viewport->is_report_old;
    TitleContent content = {.name = shown_name(app),
                            .width = viewport->width,
                            .height = viewport->height,
                            .report = has_report ? &viewport->report : NULL,
                            .time = app->scene->is_time_dependent ? &app->scene_time : NULL,
                            .is_running = app->timeline.is_running,
                            .is_recording = app_is_recording(app),
                            .light = app->selected_light,
                            .light_count = app->scene->light_count,
                            .status_text = app->title.status_text,
                            .room = (size_t)SDL_max(1, window_width / TITLE_LETTER_WIDTH)};
    char title[TITLE_SIZE];
    title_write(&content, title);
    if (strcmp(title, SDL_GetWindowTitle(window->sdl.window)) != 0) {
        SDL_SetWindowTitle(window->sdl.window, title);
    }
    app->title.next_update_time = now + TITLE_INTERVAL;
}

/** Waits for an event or a timeout. @return Whether an event came. */
static bool wait_for_event(App *app, double now, SDL_Event *event) {
    double delay = fmin(window_timeout(&app->window, now), current_scene_timeout(app, now));
    if (held_keys_is_active(&app->input.held_keys) && window_is_ready(&app->window)) {
        delay = fmin(delay, fmax(0, app->input.next_move_time - now));
    }
    delay = fmin(delay, fmin(player_timeout(app, now), recorder_timeout(app, now)));
    if (isinf(delay)) {
        return SDL_WaitEvent(event);
    }
    return SDL_WaitEventTimeout(event, (int)ceil(delay * 1000));
}

/** Does one round of the loop. The order matters: what moves is moved before the scene is replaced,
 *  drawn and shown; the picture is captured after that, and events come last. */
static void run_frame(App *app) {
    Error error = {0};
    apply_held_keys(app, clock_now_seconds());
    player_update(app, clock_now_seconds());
    recorder_update(app, clock_now_seconds());
    if (!current_scene_update(app, clock_now_seconds(), &error) &&
        error.status != STATUS_INTERRUPTED) {
        app_report_error(app, &error);
    }
    app_sync_window(app);
    if (!scene_loader_is_busy(&app->source.loader) &&
        !window_update_renderers(&app->window, app->scene, &error)) {
        app_report_error(app, &error);
    }
    if (!window_update(&app->window, app->scene, clock_now_seconds(), &error)) {
        app_report_error(app, &error);
    }
    if (app->wants_list && app->window.gui) {
        app->wants_list = false;
        run_command(app, "lessons", 1, false); // Nobody has chosen the scene on screen.
    }
    run_requested_command(app);
    edits_handle_requests(app);
    player_handle_request(app);
    take_pending_snapshot(app);
    if (!player_capture(app, &error)) {
        app_report_error(app, &error);
    }
    app_update_status(app);
    update_title(app, clock_now_seconds());
    SDL_Event event;
    bool is_event = !app->exit.is_requested && wait_for_event(app, clock_now_seconds(), &event);
    while (is_event && !app->exit.is_requested) {
        input_handle_event(app, &event);
        // Keys after the one that ends a lesson are for what follows it.
        is_event =
            !gui_awaits_frame(app->window.gui) && !app->player.is_leaving && SDL_PollEvent(&event);
    }
}

/** Prints the latencies as one line of JSON. */
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

/** Opens the window and runs its loop until it is closed; SDL must be started. @param stop See
 *  #view_run. @return The exit status. */
static Status run_event_loop(App *app, const atomic_bool *stop, SignalThread *signal_thread,
                             Error *error) {
    const ViewSettings *settings = app->settings;
    app->first_event = SDL_RegisterEvents(EVENT_COUNT);
    app->source.loader.event = app->first_event + EVENT_SCENE_LOADED;
    signal_thread_start(signal_thread, app->first_event + EVENT_SIGNAL);
    current_scene_begin(app);
    if (!view_state_init(&app->home_view, app->scene, error) ||
        !window_open(&app->window, app->scene, &settings->render,
                     app->source.labels[language_is_french()],
                     app->first_event + EVENT_PASS_FINISHED, error)) {
        return error->status;
    }
    app->window.own_settings = settings->own ? *settings->own : settings->render;
    app_show_notes(app);
    if (settings->answer_path && !answer_file_prepare(settings->answer_path, error)) {
        return error->status;
    }
    player_begin(app);
    app->wants_list = settings->opens_list;
    while (!app->exit.is_requested) {
        run_frame(app);
        if (stop && atomic_load(stop)) {
            app->exit.is_requested = true;
            app->exit.status = STATUS_INTERRUPTED;
        }
    }
    if (!recorder_end(app, error)) {
        app->exit.status = error->status;
    }
    if (app->wants_snapshot) {
        fprintf(stderr, gettext("dioptre: no snapshot: the picture was not finished\n"));
    }
    if (settings->prints_timing) {
        print_timing(app);
    }
    return app->exit.status;
}

bool view_is_possible(void) {
    bool is_possible = video_start(NULL);
    SDL_Quit();
    return is_possible;
}

Status view_run(Scene *scene, const ViewSettings *settings, const atomic_bool *stop, Error *error) {
    App app = {.settings = settings,
               .commands = command_table,
               .scene = scene,
               .input = {.held_keys = {.speed = 1}},
               .timeline = {.time = settings->initial_time},
               .scene_time = settings->initial_time,
               .source = {.loader = {.settings = settings}}};
    app.window.help = (Help){.commands = command_table, .by_letter = settings->keys_by_letter};
    Status status = STATUS_FAILED;
    SignalThread signal_thread;
    signal_thread_block(&signal_thread);
    if (video_start(error)) {
        status = run_event_loop(&app, stop, &signal_thread, error);
        player_end(&app);
        current_scene_end(
            &app); // Before the window: a scene that still loads shares data with its renderers.
        window_close(&app.window);
    }
    signal_thread_stop(&signal_thread);
    SDL_Quit();
    view_state_deinit(&app.home_view);
    edit_history_deinit(&app.edits);
    view_history_clear(&app.moves);
    return status;
}
