/**
 * @file
 * @brief What actions do to the view.
 */
#include "view/commands/commands.h"

#include "base/language.h"
#include "view/commands/scene_text.h"
#include "view/commands/time_control.h"
#include "view/commands/view_commands.h"
#include "view/input/browser_input.h"
#include "view/lesson/recorder.h"
#include "view/loading/current_scene.h"

#include <stdio.h>
#include <stdlib.h>

/** Shows the rays of one pixel, or the picture again. */
static void toggle_rays(App *app) {
    inspector_toggle(&app->window.inspector);
    window_present(&app->window);
}

/** Closes the window. */
static void quit(App *app) {
    app->should_quit = true;
}

/** Puts the scene's own view back. */
static void reset_view(App *app) {
    inspector_reset_camera(&app->window.inspector);
    view_state_reset(&app->home_view, app->scene);
    app->selected_light = 0;
    app_on_view_changed(app);
}

/** The light keys move the next light from now on. */
static void select_next_light(App *app) {
    size_t count = app->scene->light_count;
    app->selected_light = count > 0 ? (app->selected_light + 1) % count : 0;
    if (count > 1) {
        app_clear_status(app);
    } else {
        app_set_status(app, count == 1 ? N_("there is one light") : N_("there is no light"));
    }
}

/** Opens or closes the help. */
static void toggle_help(App *app) {
    if (!help_toggle(&app->window.help)) {
        app_set_status(app, "no font found: the help is on standard output");
    }
    window_present(&app->window);
}

/** Speaks the other language. A scene that is wrong is read again, to say what is wrong in it. */
static void switch_language(App *app) {
    language_toggle();
    app_set_status(app, "messages are in English");
    current_scene_repeat_error(app);
    window_invalidate_text(&app->window);
    window_present(&app->window);
}

/** Prints camera and lights as text of the scene language, and keeps it ready to be pasted. */
static void copy_view(App *app) {
    char *text = scene_text_create(app->scene);
    if (!text) {
        app_set_status(app, "no memory for the view");
        return;
    }
    puts(text);
    fflush(stdout);
    bool is_copied = SDL_SetClipboardText(text) == 0;
    app_set_status(app, is_copied ? N_("camera and light can be pasted")
                                  : N_("camera and light are printed"));
    free(text);
}

/** Asks for a snapshot. It is of the finished picture: of the view as it is when that is there, so
 *  the time is held. */
static void request_snapshot(App *app) {
    app->wants_snapshot = true;
    timeline_pause(&app->timeline, time_control_clock(app));
    app_set_status(app, "the snapshot waits for the last pass");
}

/** Begins to record a lesson, or ends it. */
static void toggle_recording(App *app) {
    Error error = {0};
    if (!recorder_toggle(app, &error)) {
        app_report_error(app, &error);
    }
}

/** The time a step back. */
static void step_time_back(App *app) {
    time_control_step(app, -1);
}

/** The time a step on. */
static void step_time_forward(App *app) {
    time_control_step(app, 1);
}

/** Larger letters. */
static void enlarge_text(App *app) {
    window_scale_text(&app->window, 1);
}

/** Smaller letters. */
static void shrink_text(App *app) {
    window_scale_text(&app->window, -1);
}

/** The whole screen, or a window again. */
static void toggle_full_screen(App *app) {
    sdl_window_toggle_full_screen(&app->window.sdl);
}

/** The numbers of the ray before. */
static void select_previous_ray(App *app) {
    inspector_select_ray(&app->window.inspector, -1);
}

/** The numbers of the next ray. */
static void select_next_ray(App *app) {
    inspector_select_ray(&app->window.inspector, 1);
}

void command_run(App *app, Action action) {
    static void (*const commands[])(App * app) = {[ACTION_SNAPSHOT] = request_snapshot,
                                                  [ACTION_RESET_VIEW] = reset_view,
                                                  [ACTION_NEXT_LIGHT] = select_next_light,
                                                  [ACTION_TOGGLE_TIME] = time_control_toggle,
                                                  [ACTION_TIME_BACK] = step_time_back,
                                                  [ACTION_TIME_FORWARD] = step_time_forward,
                                                  [ACTION_COPY_VIEW] = copy_view,
                                                  [ACTION_TEXT_LARGER] = enlarge_text,
                                                  [ACTION_TEXT_SMALLER] = shrink_text,
                                                  [ACTION_LANGUAGE] = switch_language,
                                                  [ACTION_BROWSE_SCENES] = browser_input_open,
                                                  [ACTION_RECORD] = toggle_recording,
                                                  [ACTION_CAPTION] = caption_input_begin,
                                                  [ACTION_HELP] = toggle_help,
                                                  [ACTION_FULL_SCREEN] = toggle_full_screen,
                                                  [ACTION_TOGGLE_RAYS] = toggle_rays,
                                                  [ACTION_RAY_PREVIOUS] = select_previous_ray,
                                                  [ACTION_RAY_NEXT] = select_next_ray,
                                                  [ACTION_QUIT] = quit,
                                                  [ACTION_NONE] = NULL};
    if (commands[action]) {
        commands[action](app);
    } else {
        view_commands_run(app, action);
    }
}
