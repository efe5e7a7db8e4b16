/**
 * @file
 * @brief What the commands do.
 */
#include "view/commands/actions.h"

#include "base/language.h"
#include "dioptre/scene.h"
#include "view/commands/current_scene.h"
#include "view/commands/edits.h"
#include "view/commands/recorder.h"
#include "view/state/scene_text.h"
#include "view/state/settings_words.h"

#include <libintl.h>
#include <stdlib.h>

/** How far a key moves the bar between two pictures, as a fraction of the window's width. */
static const double BAR_STEP = 0.02;

/* --- time and view ---------------------------------------------------------------------------- */

void action_select_next_light(App *app, int argument) {
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

void action_toggle_time(App *app, int argument) {
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

void action_step_time(App *app, int steps) {
    if (app_is_animated(app)) {
        timeline_step(&app->timeline, steps, app_clock(app));
    } else {
        show_no_time_status(app);
    }
}

void action_toggle_walking(App *app, int argument) {
    (void)argument;
    bool is_walking = app->input.camera_motion == MOTION_FLY;
    app->input.camera_motion = is_walking ? MOTION_WALK : MOTION_FLY;
    app_set_status(app, is_walking ? N_("walking: forward stays at one height")
                                   : N_("flying: forward is where the camera looks"));
}

void action_reset_view(App *app, int argument) {
    (void)argument;
    app_reset_view(app);
}

/* --- how the picture is drawn ----------------------------------------------------------------- */

/** Bytes of a number as text with the final zero. */
enum { NUMBER_TEXT_SIZE = 32 };

/** @return Whether rays march through any shape of a scene. */
static bool has_marched_shape(const Scene *scene) {
    for (size_t i = 0; i < scene->shape_count; i++) {
        if (keyword_has_field(scene_shape_keywords[scene->shapes[i].class_index])) {
            return true;
        }
    }
    return false;
}

void action_set_layer(App *app, int layer) {
    window_set_layer(&app->window, (Layer)layer);
    const bool is_of_steps = layer == LAYER_STEPS || layer == LAYER_OPERATIONS;
    if (is_of_steps && !has_marched_shape(app->scene)) {
        app_set_status(app, "this scene has no distance field: no ray marches");
    }
}

/** Changes one setting of the active picture. @return The settings that it has then. */
static RenderSettings change_setting(App *app, SettingsChangeFn *change, int step) {
    window_override_setting(&app->window, change, step);
    return window_requested_settings(&app->window);
}

void action_change_engine(App *app, int step) {
    const Engine *engine = change_setting(app, settings_override_engine, step).engine;
    app_set_status(app, "number type: %s (%s)", number_type_word(number_type_of(engine)),
                   engine->name);
}

void action_change_offset(App *app, int step) {
    RenderSettings settings = change_setting(app, settings_override_offset, step);
    app_set_status(app, "offset: %s", offset_strategy_word(settings.trace.offset));
}

void action_change_epsilon(App *app, int factor) {
    OffsetStrategy before = app->window.base_settings.trace.offset;
    RenderSettings settings = change_setting(app, settings_override_epsilon, factor);
    char epsilon[NUMBER_TEXT_SIZE];
    snprintf(epsilon, sizeof epsilon, "%.3g", settings.trace.epsilon);
    language_localize_numbers(epsilon, sizeof epsilon);
    if (before != settings.trace.offset) {
        // The slider changes two settings at once, and only one of them is under the mouse.
        app_set_status(app, "epsilon: %s, offset: %s; the scene's own offset, %s, is off", epsilon,
                       offset_strategy_word(settings.trace.offset), offset_strategy_word(before));
    } else {
        app_set_status(app, "epsilon: %s", epsilon);
    }
}

void action_change_depth(App *app, int step) {
    app_set_status(app, "depth: %d",
                   change_setting(app, settings_override_depth, step).trace.depth);
}

void action_change_samples(App *app, int step) {
    app_set_status(app, "samples: %d",
                   change_setting(app, settings_override_samples, step).samples);
}

void action_change_lighting(App *app, int step) {
    RenderSettings settings = change_setting(app, settings_override_lighting, step);
    app_set_status(app, "light: %s", gettext(light_mode_name(settings.lighting)));
}

void action_change_pixel(App *app, int step) {
    RenderSettings settings = change_setting(app, settings_override_pixel, step);
    app_set_status(app, "rays go %s", gettext(pixel_point_name(settings.trace.pixel_point)));
}

void action_change_methods(App *app, int step) {
    RenderSettings settings = change_setting(app, settings_override_methods, step);
    app_set_status(app, "%s (%s)", gettext(method_set_name(settings.method_set)),
                   gettext(method_set_effect(settings.method_set)));
}

void action_reset_settings(App *app, int argument) {
    (void)argument;
    window_reset_overrides(&app->window);
    app_set_status(app, "settings as at first");
}

void action_toggle_settings(App *app, int argument) {
    (void)argument;
    window_toggle_settings(&app->window);
}

/** Says on the picture what a tool does that was chosen; a lesson says that itself. @param text In
 *  English; NULL: the tool is gone. */
static void explain_tool(App *app, const char *text) {
    if (app->player.lesson) {
        return;
    }
    if (text) {
        window_set_toast(&app->window, gettext(text));
    } else {
        window_end_toast(&app->window);
    }
}

void action_cycle_split(App *app, int step) {
    static const char *const texts[] = {
        [SPLIT_NONE] = NULL,
        [SPLIT_BAR] = N_("settings change the picture with the arrow; T: the other one; drag the "
                         "line between them"),
        [SPLIT_DIFFERENCE] = N_("left minus right, pixel by pixel; X: one picture again")};
    window_cycle_split(&app->window, step);
    explain_tool(app, texts[app->window.split.mode]);
}

void action_swap_side(App *app, int argument) {
    (void)argument;
    window_swap_active(&app->window);
}

void action_move_bar(App *app, int direction) {
    window_move_bar(&app->window, app->window.split.bar_position + direction * BAR_STEP);
}

void action_toggle_chart(App *app, int argument) {
    (void)argument;
    window_toggle_chart(&app->window);
}

void action_toggle_magnifier(App *app, int argument) {
    (void)argument;
    window_toggle_magnifier(&app->window);
    explain_tool(app, app->window.magnifier.is_on
                          ? N_("the pixels around the mouse as squares; Ctrl and arrows: one "
                               "beside; F4: away")
                          : NULL);
}

/* --- the rays of one pixel -------------------------------------------------------------------- */

void action_toggle_rays(App *app, int argument) {
    (void)argument;
    ray_view_toggle(&app->window.ray_view);
    window_present(&app->window);
}

void action_select_ray(App *app, int step) {
    ray_view_select_ray(&app->window.ray_view, step);
}

void action_fly_ray(App *app, int argument) {
    (void)argument;
    ray_view_fly(&app->window.ray_view, clock_now_seconds());
}

void action_toggle_ray_pane(App *app, int pane) {
    ray_view_toggle_pane(&app->window.ray_view, (RayPane)pane);
}

void action_turn_arrows(App *app, int argument) {
    (void)argument;
    ray_view_turn_arrows(&app->window.ray_view);
}

void action_toggle_ray_kind(App *app, int kind) {
    ray_view_toggle_kind(&app->window.ray_view, (RayType)kind);
}

/* --- objects ---------------------------------------------------------------------------------- */

void action_undo(App *app, int argument) {
    (void)argument;
    edits_undo(app);
}

void action_redo(App *app, int argument) {
    (void)argument;
    edits_redo(app);
}

void action_copy_object(App *app, int argument) {
    (void)argument;
    edits_copy(app);
}

void action_write_object(App *app, int argument) {
    (void)argument;
    edits_write(app);
}

void action_select_thing(App *app, int step) {
    edits_select_next(app, step);
}

/** @return Whether the inspector has the keyboard. See #StatusHoldsFn. */
static bool is_inspector_steered(const App *app) {
    return gui_keyboard(app->window.gui) == GUI_INSPECTOR;
}

/** @return Whether the toolbar has the keyboard. See #StatusHoldsFn. */
static bool is_toolbar_steered(const App *app) {
    return gui_keyboard(app->window.gui) == GUI_BAR;
}

void action_take_keyboard(App *app, int argument) {
    (void)argument;
    if (!object_inspector_is_open(&app->window.object_inspector)) {
        edits_select_next(app, 1);
    }
    if (object_inspector_is_open(&app->window.object_inspector) &&
        gui_give_keyboard(app->window.gui, GUI_INSPECTOR)) {
        window_present(&app->window);
        app_set_status_while(
            app, is_inspector_steered,
            N_("arrows: a field; Space, Enter: change it; Esc: the picture's keys"));
    }
}

void action_list_things(App *app, int argument) {
    (void)argument;
    Window *window = &app->window;
    if (window->object_inspector.lists && !object_inspector_has_thing(&window->object_inspector)) {
        edits_close(app);
        return;
    }
    edits_list(app);
    gui_take_keyboard(window->gui);
    if (gui_give_keyboard(window->gui, GUI_INSPECTOR)) {
        app_set_status_while(
            app, is_inspector_steered,
            N_("arrows: a thing; Space, Enter: choose it; Esc: the picture's keys"));
    }
}

void action_take_toolbar(App *app, int argument) {
    (void)argument;
    Window *window = &app->window;
    if (window->toolbar.is_folded) {
        window_toggle_toolbar(window);
    }
    if (!window->toolbar.is_folded && gui_give_keyboard(window->gui, GUI_BAR)) {
        window_present(window);
        app_set_status_while(
            app, is_toolbar_steered,
            N_("arrows: a button; Space, Enter: press it; Esc: the picture's keys"));
    }
}

void action_save_copy(App *app, int argument) {
    (void)argument;
    edits_save_copy(app);
}

/* --- the program ------------------------------------------------------------------------------ */

void action_request_snapshot(App *app, int argument) {
    (void)argument;
    app->wants_snapshot = true;
    timeline_pause(&app->timeline, app_clock(app));
    app_set_status(app, "the snapshot waits for the last pass");
}

void action_save_screen(App *app, int argument) {
    (void)argument;
    Error error = {0};
    if (!app_save_screen(app, &error)) {
        app_report_error(app, &error);
    }
}

void action_copy_view(App *app, int argument) {
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

void action_scale_text(App *app, int steps) {
    window_scale_text(&app->window, steps);
}

void action_switch_language(App *app, int argument) {
    (void)argument;
    language_toggle();
    app_set_status(app, "messages are in English");
    current_scene_repeat_error(app);
    window_invalidate_text(&app->window);
    window_relayout_toolbar(&app->window);
}

void action_browse_scenes(App *app, int argument) {
    Browser *browser = &app->window.browser;
    const bool was_covered = app->window.help.is_open;
    app->window.help.is_open = false; // It would cover the list.
    if (!browser->is_open) {
        current_scene_browse(app);
        if (argument && browser->is_open) {
            browser_begin_at_top(browser);
        }
    } else if (argument) {
        browser_go_to(browser, BROWSER_LESSONS);
    } else if (!was_covered) {
        browser_close(browser);
    }
    window_present(&app->window);
}

void action_toggle_recording(App *app, int argument) {
    (void)argument;
    Error error = {0};
    bool ok = app_is_recording(app) ? recorder_end(app, &error) : recorder_begin(app, &error);
    if (!ok) {
        app_report_error(app, &error);
    }
}

void action_begin_caption(App *app, int argument) {
    (void)argument;
    recorder_begin_caption(app);
}

void action_toggle_help(App *app, int argument) {
    (void)argument;
    if (!help_toggle(&app->window.help)) {
        app_set_status(app, "no font found: the help is on standard output");
    }
    window_present(&app->window);
}

void action_toggle_toolbar(App *app, int argument) {
    (void)argument;
    window_toggle_toolbar(&app->window);
}

void action_toggle_presentation(App *app, int argument) {
    (void)argument;
    window_toggle_presentation(&app->window);
    explain_tool(app, app->window.is_presenting
                          ? N_("for a class: large letters, no toolbar; F5: as before")
                          : NULL);
}

void action_toggle_full_screen(App *app, int argument) {
    (void)argument;
    sdl_window_toggle_full_screen(&app->window.sdl);
}
