/**
 * @file
 * @brief The table of commands, and what they do.
 *
 * The light's keys are at fixed positions, wherever the letters of the keyboard in use are: those
 * of z s q d e w on an AZERTY keyboard. So are the two keys that step the time, right of M or N: ;
 * and : on an AZERTY keyboard. SDL names positions by the US keyboard. All other keys go by what is
 * printed on them.
 */
#include "view/commands/commands.h"

#include "base/language.h"
#include "dioptre/scene.h"
#include "view/commands/current_scene.h"
#include "view/commands/edits.h"
#include "view/commands/recorder.h"
#include "view/state/scene_text.h"

#include <libintl.h>
#include <stdlib.h>

/** How far a key moves the bar between two pictures, as a fraction of the window's width. */
static const double BAR_STEP = 0.02;
/** Seconds in which the program must be left again to end a lesson. */
static const double CONFIRMATION_SECONDS = 4;

/* --- time and view ---------------------------------------------------------------------------- */

/** Selects the next light for the light's keys. */
static void select_next_light(App *app, int argument) {
    (void)argument;
    size_t count = app->scene->light_count;
    app->selected_light = count > 0 ? (app->selected_light + 1) % count : 0;
    if (count > 1) {
        app_clear_status(app);
    } else {
        app_set_status(app, count == 1 ? N_("there is one light") : N_("there is no light"));
    }
}

/** Reports that the scene does not depend on time. */
static void show_no_time_status(App *app) {
    app_set_status(app, "this scene does not ask for the time t");
}

/** Pauses the time, or lets it run. */
static void toggle_time(App *app, int argument) {
    (void)argument;
    if (!app_is_animated(app)) {
        show_no_time_status(app);
    } else if (app->timeline.is_running) {
        timeline_pause(&app->timeline, app_clock(app));
    } else {
        timeline_run(&app->timeline, app_clock(app));
    }
    app->title.next_update_time = 0;
}

/** Pauses the time, and moves it some steps. */
static void step_time(App *app, int steps) {
    if (app_is_animated(app)) {
        timeline_step(&app->timeline, steps, app_clock(app));
    } else {
        show_no_time_status(app);
    }
}

/** Changes between flying and walking. */
static void toggle_walking(App *app, int argument) {
    (void)argument;
    bool is_walking = app->input.camera_motion == MOTION_FLY;
    app->input.camera_motion = is_walking ? MOTION_WALK : MOTION_FLY;
    app_set_status(app, is_walking ? N_("walking: forward stays at one height")
                                   : N_("flying: forward is where the camera looks"));
}

/** Puts the scene's own view back. */
static void reset_view(App *app, int argument) {
    (void)argument;
    app_reset_view(app);
}

/* --- how the picture is drawn ----------------------------------------------------------------- */

/** Shows the settings of the active picture in the title. */
static void show_settings_status(App *app) {
    RenderSettings settings = window_requested_settings(&app->window);
    app_set_status(app, "%s, offset %s, epsilon %.3g, depth %d, samples %d, light: %s",
                   settings.engine->name, offset_strategy_names[settings.trace.offset],
                   settings.trace.epsilon, settings.trace.depth, settings.samples,
                   gettext(light_mode_name(settings.lighting)));
}

/** @return Whether rays march through any shape of a scene. */
static bool has_marched_shape(const Scene *scene) {
    for (size_t i = 0; i < scene->shape_count; i++) {
        if (keyword_has_field(scene_shape_keywords[scene->shapes[i].class_index])) {
            return true;
        }
    }
    return false;
}

/** Shows a layer. */
static void set_layer(App *app, int layer) {
    window_set_layer(&app->window, (Layer)layer);
    if (layer == LAYER_STEPS && !has_marched_shape(app->scene)) {
        app_set_status(app, "this scene has no distance field: no ray marches");
    }
}

/** Changes one setting of the active picture. */
static void change_setting(App *app, SettingsChangeFn *change, int step) {
    window_override_setting(&app->window, change, step);
    show_settings_status(app);
}

/** Changes the number type. See #settings_override_engine. */
static void change_engine(App *app, int step) {
    change_setting(app, settings_override_engine, step);
}

/** Changes the offset strategy. See #settings_override_offset. */
static void change_offset(App *app, int step) {
    change_setting(app, settings_override_offset, step);
}

/** Scales epsilon. See #settings_override_epsilon. */
static void change_epsilon(App *app, int factor) {
    change_setting(app, settings_override_epsilon, factor);
}

/** Changes the depth. See #settings_override_depth. */
static void change_depth(App *app, int step) {
    change_setting(app, settings_override_depth, step);
}

/** Changes the samples. See #settings_override_samples. */
static void change_samples(App *app, int step) {
    change_setting(app, settings_override_samples, step);
}

/** Changes the lighting mode. See #settings_override_lighting. */
static void change_lighting(App *app, int step) {
    change_setting(app, settings_override_lighting, step);
}

/** Sends rays through the centres or the corners of pixels. See #settings_override_pixel. */
static void change_pixel(App *app, int step) {
    window_override_setting(&app->window, settings_override_pixel, step);
    RenderSettings settings = window_requested_settings(&app->window);
    app_set_status(app, "rays go %s", gettext(pixel_point_name(settings.trace.pixel_point)));
}

/** Changes whose methods the picture is traced with. See #settings_override_methods. */
static void change_methods(App *app, int step) {
    window_override_setting(&app->window, settings_override_methods, step);
    RenderSettings settings = window_requested_settings(&app->window);
    app_set_status(app, "%s (%s)", gettext(method_set_name(settings.method_set)),
                   gettext(method_set_effect(settings.method_set)));
}

/** Takes all changes of settings, layers and the split view back. */
static void reset_settings(App *app, int argument) {
    (void)argument;
    window_reset_overrides(&app->window);
    show_settings_status(app);
}

/** Shows or hides settings and costs. */
static void toggle_settings(App *app, int argument) {
    (void)argument;
    window_toggle_settings(&app->window);
}

/** Shows one picture, two side by side, or their difference. */
static void cycle_split(App *app, int step) {
    window_cycle_split(&app->window, step);
}

/** Makes the other of two pictures the active one. */
static void swap_side(App *app, int argument) {
    (void)argument;
    window_swap_active(&app->window);
}

/** Moves the bar between two pictures. */
static void move_bar(App *app, int direction) {
    window_move_bar(&app->window, app->window.split.bar_position + direction * BAR_STEP);
}

/** Shows or hides the chart of settings. */
static void toggle_chart(App *app, int argument) {
    (void)argument;
    window_toggle_chart(&app->window);
}

/** Shows or hides the magnifier. */
static void toggle_magnifier(App *app, int argument) {
    (void)argument;
    window_toggle_magnifier(&app->window);
}

/* --- the rays of one pixel -------------------------------------------------------------------- */

/** Shows the rays of one pixel, or the picture again. */
static void toggle_rays(App *app, int argument) {
    (void)argument;
    ray_view_toggle(&app->window.ray_view);
    window_present(&app->window);
}

/** Chooses another ray. */
static void select_ray(App *app, int step) {
    ray_view_select_ray(&app->window.ray_view, step);
}

/** Lets the next ray fly along its path. */
static void fly_ray(App *app, int argument) {
    (void)argument;
    ray_view_fly(&app->window.ray_view, clock_now_seconds());
}

/** Shows a drawing beside the rays, or takes it away. */
static void toggle_ray_pane(App *app, int pane) {
    ray_view_toggle_pane(&app->window.ray_view, (RayPane)pane);
}

/** Turns the arrows of rays round. */
static void turn_arrows(App *app, int argument) {
    (void)argument;
    ray_view_turn_arrows(&app->window.ray_view);
}

/** Hides the rays of a kind, or shows them again. */
static void toggle_ray_kind(App *app, int kind) {
    ray_view_toggle_kind(&app->window.ray_view, (RayType)kind);
}

/* --- objects ---------------------------------------------------------------------------------- */

/** Takes the last change of an object back. */
static void undo(App *app, int argument) {
    (void)argument;
    edits_undo(app);
}

/** Does the change again that was taken back. */
static void redo(App *app, int argument) {
    (void)argument;
    edits_redo(app);
}

/** Copies the selected object as text. */
static void copy_object(App *app, int argument) {
    (void)argument;
    edits_copy(app);
}

/** Writes the selected object into the scene file. */
static void write_object(App *app, int argument) {
    (void)argument;
    edits_write(app);
}

/* --- the program ------------------------------------------------------------------------------ */

/** Requests a snapshot. It is taken when the picture is finished, so the time is paused. */
static void request_snapshot(App *app, int argument) {
    (void)argument;
    app->wants_snapshot = true;
    timeline_pause(&app->timeline, app_clock(app));
    app_set_status(app, "the snapshot waits for the last pass");
}

/** Saves what is on the screen. */
static void save_screen(App *app, int argument) {
    (void)argument;
    Error error = {0};
    if (!app_save_screen(app, &error)) {
        app_report_error(app, &error);
    }
}

/** Prints camera and lights as text of the scene language, and puts it on the clipboard. */
static void copy_view(App *app, int argument) {
    (void)argument;
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

/** Makes the letters larger or smaller. */
static void scale_text(App *app, int steps) {
    window_scale_text(&app->window, steps);
}

/** Changes the language. A faulty scene is loaded again, for its error in that language. */
static void switch_language(App *app, int argument) {
    (void)argument;
    language_toggle();
    app_set_status(app, "messages are in English");
    current_scene_repeat_error(app);
    window_invalidate_text(&app->window);
    window_relayout_toolbar(&app->window);
}

/** Opens the list of scenes. */
static void browse_scenes(App *app, int argument) {
    (void)argument;
    current_scene_browse(app);
}

/** Begins to record a lesson, or ends it. */
static void toggle_recording(App *app, int argument) {
    (void)argument;
    Error error = {0};
    bool ok = app_is_recording(app) ? recorder_end(app, &error) : recorder_begin(app, &error);
    if (!ok) {
        app_report_error(app, &error);
    }
}

/** Begins to type a caption. */
static void begin_caption(App *app, int argument) {
    (void)argument;
    recorder_begin_caption(app);
}

/** Opens or closes the help. */
static void toggle_help(App *app, int argument) {
    (void)argument;
    if (!help_toggle(&app->window.help)) {
        app_set_status(app, "no font found: the help is on standard output");
    }
    window_present(&app->window);
}

/** Shows or hides the toolbar. */
static void toggle_toolbar(App *app, int argument) {
    (void)argument;
    window_toggle_toolbar(&app->window);
}

/** Begins or ends a presentation. */
static void toggle_presentation(App *app, int argument) {
    (void)argument;
    window_toggle_presentation(&app->window);
}

/** Changes between the full screen and a window. */
static void toggle_full_screen(App *app, int argument) {
    (void)argument;
    sdl_window_toggle_full_screen(&app->window.sdl);
}

void command_leave_program(App *app) {
    double now = clock_now_seconds();
    bool needs_confirmation = app_is_playing(app) || app_is_recording(app);
    if (!needs_confirmation || now < app->exit.confirmation_end) {
        app->player.is_leaving = app_is_playing(app);
        app->exit.is_requested = !app->player.is_leaving;
        app->exit.confirmation_end = 0;
        return;
    }
    app->exit.confirmation_end = now + CONFIRMATION_SECONDS;
    app_set_status(app, app_is_playing(app) ? N_("a lesson plays: leave again to end it")
                                            : N_("a lesson is recorded: leave again to end it"));
}

/** Issues a command by its name. */
static void issue(App *app, const char *name) {
    command_issue(app, command_find(app->commands, name), clock_now_seconds());
}

/** Closes what lies topmost: help, a lesson's end card, rays, inspector, two pictures, a layer, the full screen; at last the
 *  program. What a lesson shows stays. */
static void leave(App *app, int argument) {
    (void)argument;
    Window *window = &app->window;
    bool is_full = SDL_GetWindowFlags(window->sdl.window) & SDL_WINDOW_FULLSCREEN_DESKTOP;
    bool is_own = !app_is_playing(app);
    if (gui_close_list(window->gui)) {
        return;
    }
    if (window->help.is_open) {
        toggle_help(app, 0);
    } else if (app->player.lesson && is_own) {
        app->player.is_leaving = true;
    } else if (is_own && window->ray_view.is_open) {
        issue(app, "rays");
    } else if (is_own && window->settings_chart.is_open) {
        issue(app, "chart");
    } else if (is_own && window->object_inspector.number > 0) {
        edits_close(app);
    } else if (is_own && window->magnifier.is_on) {
        issue(app, "magnifier");
    } else if (is_own && window->split.mode != SPLIT_NONE) {
        issue(app, window->split.mode == SPLIT_BAR ? "split back" : "split");
    } else if (is_own && window_active_viewport(window)->layer != LAYER_SHADED) {
        issue(app, "layer light");
    } else if (is_full) {
        toggle_full_screen(app, 0);
    } else {
        command_leave_program(app);
    }
}

/* --- the table -------------------------------------------------------------------------------- */

/** A key by its position, named by the US keyboard, and by its letter with `--keys letters`. */
#define PLACE(position, letter)                                                                    \
    { .scancode = SDL_SCANCODE_##position, .keycode = SDLK_##letter }
/** A key by its position, always, with its name in the help. */
#define ONLY_PLACE(position, name_)                                                                \
    { .scancode = SDL_SCANCODE_##position, .label = name_ }
/** A key by what is printed on it. */
#define KEY(letter)                                                                                \
    { .keycode = SDLK_##letter }
/** A key by what is printed on it, with its name in the help; empty: none. */
#define NAMED(letter, name_)                                                                       \
    { .keycode = SDLK_##letter, .label = name_ }
/** No key, only a name in the help. */
#define NO_KEY(name_)                                                                              \
    { .label = name_ }

/** Heading of the help: keys of the lights. */
#define LIGHT .group = N_("Light")
/** Heading of the help: keys of the camera. */
#define CAMERA .group = N_("Camera")
/** Heading of the help: keys of the time. */
#define TIME .group = N_("Time")
/** Heading of the help: what is shown, and how it is rendered. */
#define PICTURE .group = N_("Picture")
/** Heading of the help: what is changed of shapes and lights. */
#define OBJECTS .group = N_("Objects")
/** Heading of the help: keys of the ray tree. */
#define RAYS .group = N_("Rays of one pixel")
/** Heading of the help: all other keys. */
#define PROGRAM .group = N_("Program")

/** A move along an axis of the picture (1) or against it (-1). */
#define MOVES(subject_, axis_, sign_)                                                              \
    .flags = COMMAND_WHILE_PAUSED, .move = {MOVE_##subject_, MOVE_##axis_, sign_}
/** A function with its argument. */
#define RUNS(function, argument_) .run = function, .argument = argument_

/** The help of the first five layers. */
#define FIRST_LAYERS .help = N_("light, normals, distance, shapes, (u, v)")
/** The help of the other layers. */
#define LAST_LAYERS .help = N_("rays, marching, time, error, acne; rounding")
/** The help of the keys that choose rays. */
#define RAY_STEPS .help = N_("ray before, after, in flight (Shift 1 to 8: more)")
/** The help of the keys that show values of the picture, and of the one that resets all. */
#define SHOWN_VALUES .help = N_("costs, magnifier, chart; all as at first")
/** The help of the keys of epsilon. */
#define EPSILON .help = N_("epsilon half, twice (Shift: 1/10, 10 times)")

// clang-format off
const Command command_table[] = {
    {"light up", {PLACE(W, z)}, N_("up"), LIGHT, .help = N_("up, down"), MOVES(LIGHT, UP, 1)},
    {"light down", {PLACE(S, s)}, N_("down"), LIGHT, .help = N_("up, down"), MOVES(LIGHT, UP, -1)},
    {"light left", {PLACE(A, q)}, N_("left"), LIGHT, .help = N_("left, right"), MOVES(LIGHT, RIGHT, -1)},
    {"light right", {PLACE(D, d)}, N_("right"), LIGHT, .help = N_("left, right"), MOVES(LIGHT, RIGHT, 1)},
    {"light away", {PLACE(E, e)}, N_("away"), LIGHT, .help = N_("away from you, nearer"), MOVES(LIGHT, FORWARD, 1)},
    {"light nearer", {PLACE(Z, w)}, N_("near"), LIGHT, .help = N_("away from you, nearer"), MOVES(LIGHT, FORWARD, -1)},
    {"next light", {NAMED(TAB, N_("Tab"))}, N_("next"), LIGHT, .help = N_("next light"),
     .flags = COMMAND_WHILE_PAUSED, RUNS(select_next_light, 0)},

    {"camera up", {NAMED(UP, "↑")}, N_("up"), CAMERA, .help = N_("up, down"), MOVES(CAMERA, UP, 1)},
    {"camera down", {NAMED(DOWN, "↓")}, N_("down"), CAMERA, .help = N_("up, down"), MOVES(CAMERA, UP, -1)},
    {"camera left", {NAMED(LEFT, "←")}, N_("left"), CAMERA, .help = N_("left, right"), MOVES(CAMERA, RIGHT, -1)},
    {"camera right", {NAMED(RIGHT, "→")}, N_("right"), CAMERA, .help = N_("left, right"), MOVES(CAMERA, RIGHT, 1)},
    {"camera forward", {NAMED(PAGEUP, N_("Page Up"))}, N_("forward"), CAMERA, .help = N_("forward, back"), MOVES(CAMERA, FORWARD, 1)},
    {"camera back", {NAMED(PAGEDOWN, N_("Page Down"))}, N_("back"), CAMERA, .help = N_("forward, back"), MOVES(CAMERA, FORWARD, -1)},
    {"walk", {NAMED(END, N_("End"))}, N_("walk"), CAMERA, .help = N_("walk at one height, or fly"), RUNS(toggle_walking, 0)},
    {NULL, {NO_KEY(N_("Mouse drag"))}, NULL, CAMERA, .help = N_("look around")},
    {NULL, {NO_KEY(N_("Wheel"))}, NULL, CAMERA, .help = N_("field of view")},

    {"time", {NAMED(SPACE, N_("Space"))}, NULL, TIME, .help = N_("run, hold"), RUNS(toggle_time, 0)},
    {"time back", {PLACE(COMMA, COMMA)}, N_("back"), TIME, .help = N_("a step back, on"), .flags = COMMAND_REPEATS, RUNS(step_time, -1)},
    {"time on", {PLACE(PERIOD, PERIOD)}, N_("on"), TIME, .help = N_("a step back, on"), .flags = COMMAND_REPEATS, RUNS(step_time, 1)},

    {"layer light", {ONLY_PLACE(1, "1")}, N_("light"), PICTURE, FIRST_LAYERS, RUNS(set_layer, LAYER_SHADED)},
    {"layer normals", {ONLY_PLACE(2, "2")}, N_("normals"), PICTURE, FIRST_LAYERS, RUNS(set_layer, LAYER_NORMALS)},
    {"layer distance", {ONLY_PLACE(3, "3")}, N_("distance"), PICTURE, FIRST_LAYERS, RUNS(set_layer, LAYER_DISTANCE)},
    {"layer shapes", {ONLY_PLACE(4, "4")}, N_("shapes"), PICTURE, FIRST_LAYERS, RUNS(set_layer, LAYER_SHAPES)},
    {"layer places", {ONLY_PLACE(5, "5")}, "(u, v)", PICTURE, FIRST_LAYERS, RUNS(set_layer, LAYER_UV)},
    {"layer rays", {ONLY_PLACE(6, "6")}, N_("rays"), PICTURE, LAST_LAYERS, RUNS(set_layer, LAYER_RAYS)},
    {"layer steps", {ONLY_PLACE(7, "7")}, N_("march"), PICTURE, LAST_LAYERS, RUNS(set_layer, LAYER_STEPS)},
    {"layer time", {ONLY_PLACE(8, "8")}, N_("time"), PICTURE, LAST_LAYERS, RUNS(set_layer, LAYER_TIME)},
    {"layer error", {ONLY_PLACE(9, "9")}, N_("error"), PICTURE, LAST_LAYERS, RUNS(set_layer, LAYER_ERROR)},
    {"layer acne", {ONLY_PLACE(0, "0")}, N_("acne"), PICTURE, LAST_LAYERS, RUNS(set_layer, LAYER_ACNE)},
    {"layer rounding", {KEY(y)}, N_("round"), PICTURE, LAST_LAYERS, RUNS(set_layer, LAYER_ROUNDING)},
    {"offset", {KEY(o)}, N_("offset"), PICTURE, .help = N_("offset: none, fixed, bound"), RUNS(change_offset, 1)},
    {"offset back", {KEY(o)}, .flags = COMMAND_SHIFT, RUNS(change_offset, -1)},
    {"epsilon half", {ONLY_PLACE(LEFTBRACKET, NULL)}, "ε / 2", PICTURE, EPSILON, .flags = COMMAND_REPEATS, RUNS(change_epsilon, -2)},
    {"epsilon tenth", {ONLY_PLACE(LEFTBRACKET, NULL)}, .flags = COMMAND_SHIFT | COMMAND_REPEATS, RUNS(change_epsilon, -10)},
    {"epsilon twice", {ONLY_PLACE(RIGHTBRACKET, NULL)}, "ε × 2", PICTURE, EPSILON, .flags = COMMAND_REPEATS, RUNS(change_epsilon, 2)},
    {"epsilon ten times", {ONLY_PLACE(RIGHTBRACKET, NULL)}, .flags = COMMAND_SHIFT | COMMAND_REPEATS, RUNS(change_epsilon, 10)},
    {"engine", {KEY(g)}, N_("engine"), PICTURE, .help = N_("float, double, quad; which light"), RUNS(change_engine, 1)},
    {"engine back", {KEY(g)}, .flags = COMMAND_SHIFT, RUNS(change_engine, -1)},
    {"light mode", {KEY(m)}, N_("light"), PICTURE, .help = N_("float, double, quad; which light"), RUNS(change_lighting, 1)},
    {"light mode back", {KEY(m)}, .flags = COMMAND_SHIFT, RUNS(change_lighting, -1)},
    {"deeper", {KEY(b)}, N_("depth"), PICTURE, .help = N_("deeper, more samples (Shift: less)"), RUNS(change_depth, 1)},
    {"less deep", {KEY(b)}, .flags = COMMAND_SHIFT, RUNS(change_depth, -1)},
    {"samples twice", {KEY(n)}, N_("samples"), PICTURE, .help = N_("deeper, more samples (Shift: less)"), RUNS(change_samples, 1)},
    {"samples half", {KEY(n)}, .flags = COMMAND_SHIFT, RUNS(change_samples, -1)},
    {"methods", {KEY(u)}, N_("reports"), PICTURE, .help = N_("as report A, B, C, D; pixel corners"), RUNS(change_methods, 1)},
    {"methods back", {KEY(u)}, .flags = COMMAND_SHIFT, RUNS(change_methods, -1)},
    {"pixel corners", {KEY(F8)}, N_("corners"), PICTURE, .help = N_("as report A, B, C, D; pixel corners"), RUNS(change_pixel, 1)},
    {"settings", {KEY(i)}, N_("costs"), PICTURE, SHOWN_VALUES, RUNS(toggle_settings, 0)},
    {"chart", {KEY(F9)}, N_("chart"), PICTURE, SHOWN_VALUES, RUNS(toggle_chart, 0)},
    {"magnifier", {KEY(F4)}, N_("magnify"), PICTURE, SHOWN_VALUES, RUNS(toggle_magnifier, 0)},
    {"as at first", {NAMED(BACKSPACE, N_("Backspace"))}, N_("as at first"), PICTURE, SHOWN_VALUES, RUNS(reset_settings, 0)},
    {"split", {KEY(x)}, N_("split"), PICTURE, .help = N_("side by side, difference; which side"), RUNS(cycle_split, 1)},
    {"split back", {KEY(x)}, .flags = COMMAND_SHIFT, RUNS(cycle_split, -1)},
    {"other side", {KEY(t)}, N_("side"), PICTURE, .help = N_("side by side, difference; which side"), RUNS(swap_side, 0)},
    {"bar left", {KEY(F6)}, N_("bar ←"), PICTURE, .help = N_("bar left, right; or the mouse"), .flags = COMMAND_REPEATS, RUNS(move_bar, -1)},
    {"bar right", {KEY(F7)}, N_("bar →"), PICTURE, .help = N_("bar left, right; or the mouse"), .flags = COMMAND_REPEATS, RUNS(move_bar, 1)},

    {NULL, {NO_KEY(N_("Click"))}, NULL, OBJECTS, .help = N_("select: sliders for all of it")},
    {"undo", {KEY(z)}, NULL, OBJECTS, .help = N_("Ctrl: take a change back (Shift: again)"), .flags = COMMAND_CTRL | COMMAND_REPEATS, RUNS(undo, 0)},
    {"redo", {KEY(y)}, .flags = COMMAND_CTRL | COMMAND_REPEATS, RUNS(redo, 0)},
    {"undo back", {KEY(z)}, .flags = COMMAND_CTRL | COMMAND_SHIFT | COMMAND_REPEATS, RUNS(redo, 0)},
    {"copy object", {KEY(c)}, NULL, OBJECTS, .help = N_("Ctrl: its text, to paste; into the file"), .flags = COMMAND_CTRL | COMMAND_UNRECORDED, RUNS(copy_object, 0)},
    {"write object", {KEY(s)}, NULL, OBJECTS, .help = N_("Ctrl: its text, to paste; into the file"), .flags = COMMAND_CTRL | COMMAND_UNRECORDED, RUNS(write_object, 0)},

    {"rays", {KEY(v)}, N_("rays"), RAYS, .help = N_("show them, or the picture again"), RUNS(toggle_rays, 0)},
    {NULL, {NO_KEY(N_("Click"))}, NULL, RAYS, .help = N_("of that pixel")},
    {NULL, {NO_KEY("Ctrl ←↑↓→")}, NULL, RAYS, .help = N_("of the pixel beside")},
    {"ray back", {KEY(j)}, N_("ray −"), RAYS, RAY_STEPS, .flags = COMMAND_REPEATS, RUNS(select_ray, -1)},
    {"ray on", {KEY(k)}, N_("ray +"), RAYS, RAY_STEPS, .flags = COMMAND_REPEATS, RUNS(select_ray, 1)},
    {"fly ray", {NO_KEY(N_("Space"))}, NULL, RAYS, RAY_STEPS, RUNS(fly_ray, 0)},
    {"camera rays", {ONLY_PLACE(1, N_("Shift 1"))}, NULL, .flags = COMMAND_SHIFT, RUNS(toggle_ray_kind, RAY_CAMERA)},
    {"shadow rays", {ONLY_PLACE(2, N_("Shift 2"))}, NULL, .flags = COMMAND_SHIFT, RUNS(toggle_ray_kind, RAY_SHADOW)},
    {"mirrored rays", {ONLY_PLACE(3, N_("Shift 3"))}, NULL, .flags = COMMAND_SHIFT, RUNS(toggle_ray_kind, RAY_REFLECTION)},
    {"refracted rays", {ONLY_PLACE(4, N_("Shift 4"))}, NULL, .flags = COMMAND_SHIFT, RUNS(toggle_ray_kind, RAY_REFRACTION)},
    {"arrows", {ONLY_PLACE(5, N_("Shift 5"))}, NULL, .flags = COMMAND_SHIFT, RUNS(turn_arrows, 0)},
    {"ray plan", {ONLY_PLACE(6, N_("Shift 6"))}, NULL, .flags = COMMAND_SHIFT, RUNS(toggle_ray_pane, RAY_PANE_PLAN)},
    {"ray march", {ONLY_PLACE(7, N_("Shift 7"))}, NULL, .flags = COMMAND_SHIFT, RUNS(toggle_ray_pane, RAY_PANE_MARCH)},
    {"hit microscope", {ONLY_PLACE(8, N_("Shift 8"))}, NULL, .flags = COMMAND_SHIFT, RUNS(toggle_ray_pane, RAY_PANE_MICROSCOPE)},
    {NULL, {NO_KEY("←↑↓→")}, NULL, RAYS, .help = N_("around them; or the mouse")},

    {NULL, {ONLY_PLACE(LSHIFT, N_("Shift")), ONLY_PLACE(RSHIFT, "")}, N_("fast"), PROGRAM, .help = N_("with a move: fast, fine")},
    {NULL, {ONLY_PLACE(LCTRL, N_("Ctrl")), ONLY_PLACE(RCTRL, "")}, N_("fine"), PROGRAM, .help = N_("with a move: fast, fine")},
    {"home", {NAMED(HOME, N_("Home"))}, N_("reset"), PROGRAM, .help = N_("the scene's own view"),
     .flags = COMMAND_WHILE_PAUSED, RUNS(reset_view, 0)},
    {"snapshot", {KEY(p), KEY(F12)}, N_("photo"), PROGRAM, .help = N_("snapshot (Shift: as on the screen)"), .flags = COMMAND_WHILE_PLAYING, RUNS(request_snapshot, 0)},
    {"snapshot of the screen", {KEY(p), KEY(F12)}, .flags = COMMAND_SHIFT | COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(save_screen, 0)},
    {"copy", {KEY(c)}, N_("copy"), PROGRAM, .help = N_("camera and light as text, to paste"),
     .flags = COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(copy_view, 0)},
    {"text larger", {NAMED(PLUS, "+"), NAMED(EQUALS, ""), NAMED(KP_PLUS, "")}, "A +", PROGRAM, .help = N_("larger, smaller letters"),
     .flags = COMMAND_WHILE_PLAYING | COMMAND_REPEATS, RUNS(scale_text, 1)},
    {"text smaller", {NAMED(MINUS, "-"), NAMED(KP_MINUS, "")}, "A −", PROGRAM, .help = N_("larger, smaller letters"),
     .flags = COMMAND_WHILE_PLAYING | COMMAND_REPEATS, RUNS(scale_text, -1)},
    {"language", {KEY(l)}, "en / fr", PROGRAM, .help = N_("English, français"),
     .flags = COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(switch_language, 0)},
    {"scenes", {KEY(f)}, N_("scenes"), PROGRAM, .help = N_("other scenes: a list with pictures"), .flags = COMMAND_UNRECORDED, RUNS(browse_scenes, 0)},
    {"record", {KEY(r)}, N_("record"), PROGRAM, .help = N_("record a lesson, or end it"), .flags = COMMAND_UNRECORDED, RUNS(toggle_recording, 0)},
    {"caption", {NAMED(RETURN, N_("Enter"))}, N_("words"), PROGRAM, .help = N_("words for that lesson"), .flags = COMMAND_UNRECORDED, RUNS(begin_caption, 0)},
    {"help", {KEY(F1), KEY(h)}, N_("help"), PROGRAM, .help = N_("this help"), .flags = COMMAND_WHILE_PLAYING, RUNS(toggle_help, 0)},
    {"toolbar", {KEY(F2)}, N_("tools"), PROGRAM, .help = N_("toolbar, full screen"),
     .flags = COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(toggle_toolbar, 0)},
    {"presentation", {KEY(F5)}, N_("class"), PROGRAM, .help = N_("for a class: large letters, no toolbar"),
     .flags = COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(toggle_presentation, 0)},
    {"full screen", {KEY(F11)}, N_("screen"), PROGRAM, .help = N_("toolbar, full screen"), .flags = COMMAND_WHILE_PLAYING, RUNS(toggle_full_screen, 0)},
    {"leave", {NAMED(ESCAPE, N_("Esc"))}, N_("leave"), PROGRAM, .help = N_("leave"),
     .flags = COMMAND_UNRECORDED | COMMAND_WHILE_PLAYING, RUNS(leave, 0)},
    {0},
};
// clang-format on

/* --- running ---------------------------------------------------------------------------------- */

void command_run(App *app, const Command *command) {
    command->run(app, command->argument);
}

void command_choose_ray(App *app, size_t ray) {
    recorder_on_step(app, "ray(%zu)", ray);
    app_choose_ray(app, ray);
}

void command_issue(App *app, const Command *command, double time) {
    recorder_on_command(app, command, time);
    if (!command_is_move(command)) {
        command_run(app, command);
        return;
    }
    // While a lesson is recorded, things move at the ticks of its clock.
    if (!app_is_recording(app)) {
        held_keys_press(&app->input.held_keys, command->move, time);
    }
    latency_on_input(&app->window.latency, time);
    app->input.next_move_time = 0;
}
