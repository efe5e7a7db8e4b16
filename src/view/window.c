/**
 * @file
 * @brief Composing viewports and panels.
 */
#include "view/window_internal.h"

#include "base/language.h"
#include "view/window/window_icon.h"

#include <libintl.h>
#include <stdlib.h>

/** Factor of the size of letters per step. */
static const double TEXT_SCALE_STEP = 1.2;
/** Largest factor of the size of letters; the smallest is its inverse. */
static const double TEXT_SCALE_MAXIMUM = 3;

/** Seconds after a change of a setting that the panel of settings stays by itself. */
static const double SETTINGS_SECONDS = 12;
/** Seconds that the name of a layer is shown in a presentation. */
static const double LAYER_NAME_SECONDS = 2.5;

/** Distance from the bar at which the mouse drags it, fraction of the picture's width. */
static const double BAR_REACH = 0.015;

bool window_open(Window *window, const Scene *scene, const RenderSettings *settings,
                 const char *title, uint32_t pass_event, Error *error) {
    window->pass_event = pass_event;
    window->settings_chart.meter.event = pass_event; // Its data1 is no viewport.
    window->base_settings = window->own_settings = *settings;
    split_view_move_bar(&window->split, 0.5);
    return viewport_open(&window->viewports[0], NULL, scene, settings, pass_event, error) &&
           sdl_window_open(&window->sdl, title, settings->width, settings->height, error);
}

void window_close(Window *window) {
    settings_chart_panel_deinit(&window->settings_chart);
    ray_view_deinit(&window->ray_view);
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        viewport_close(&window->viewports[i]);
    }
    split_view_deinit(&window->split);
    gui_destroy(window->gui);
    window->gui = NULL;
    browser_deinit(&window->browser);
    window_invalidate_text(window);
    sdl_window_close(&window->sdl);
    latency_deinit(&window->latency);
}

/* --- pictures --------------------------------------------------------------------------------- */

size_t window_viewport_count(const Window *window) {
    return window->split.mode != SPLIT_NONE && window->viewports[1].renderer ? 2 : 1;
}

/** @return Index of the active viewport. */
static size_t active_index(const Window *window) {
    return window_viewport_count(window) > 1 ? window->split.active : 0;
}

Viewport *window_active_viewport(Window *window) {
    return &window->viewports[active_index(window)];
}

RenderSettings window_requested_settings(const Window *window) {
    RenderSettings settings = window->base_settings;
    settings_override_apply(&window->viewports[active_index(window)].overrides, &settings);
    return settings;
}

void window_invalidate(Window *window) {
    settings_chart_panel_clear(&window->settings_chart);
    for (size_t i = 0; i < window_viewport_count(window); i++) {
        window->viewports[i].needs_restart = true;
        window->viewports[i].previous_render_seconds = 0;
    }
}

/** Has the panels updated at once. */
static void update_text_now(Window *window) {
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        window->huds[i].next_update_time = 0;
    }
}

void window_set_layer(Window *window, Layer layer) {
    update_text_now(window);
    viewport_set_layer(window_active_viewport(window), layer);
    if (window->is_presenting) {
        SDL_strlcpy(window->layer_name.text, gettext(layer_name(layer)),
                    sizeof window->layer_name.text);
        window->layer_name.end_time = clock_now_seconds() + LAYER_NAME_SECONDS;
    }
}

void window_tell_settings(Window *window) {
    update_text_now(window);
    // An open toolbar shows those of one picture.
    bool is_told = !window->toolbar.is_folded && window_viewport_count(window) == 1;
    if (!is_told && (!window->shows_settings || window->settings_end_time > 0)) {
        window->shows_settings = true;
        window->settings_end_time = clock_now_seconds() + SETTINGS_SECONDS;
    }
}

void window_override_setting(Window *window, SettingsChangeFn *change, int step) {
    window_tell_settings(window);
    viewport_override_setting(window_active_viewport(window), &window->base_settings, change, step);
}

void window_request_new_renderers(Window *window) {
    for (size_t i = 0; i < window_viewport_count(window); i++) {
        window->viewports[i].needs_new_renderer = true;
    }
}

PictureChoice window_choice(const Window *window) {
    PictureChoice choice = {.split = window->split.mode,
                            .active = window->split.active,
                            .bar_position = window->split.bar_position};
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        choice.overrides[i] = window->viewports[i].overrides;
        choice.layers[i] = window->viewports[i].layer;
    }
    return choice;
}

/** Changes how pictures share the window. */
static void set_split(Window *window, SplitMode mode) {
    window->split.mode = mode;
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        window->viewports[i].has_new_pass = window->viewports[i].renderer != NULL;
    }
}

void window_choose(Window *window, const PictureChoice *choice) {
    update_text_now(window);
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        viewport_choose(&window->viewports[i], &window->base_settings, &choice->overrides[i],
                        choice->layers[i]);
    }
    if (choice->split != window->split.mode) {
        set_split(window, choice->split);
    }
    window->split.active = choice->active;
    split_view_move_bar(&window->split, choice->bar_position);
    window_present(window);
}

void window_reset_overrides(Window *window) {
    const PictureChoice at_first = {.active = window->split.active, .bar_position = 0.5};
    window_choose(window, &at_first);
}

void window_take_own_settings(Window *window) {
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        settings_override_rebase(&window->viewports[i].overrides, &window->base_settings,
                                 &window->own_settings);
    }
    window->base_settings = window->own_settings;
}

void window_forget_changes(Window *window) {
    window_reset_overrides(window);
    window->viewports[0].needs_new_renderer = false; // It comes with the scene.
    window->magnifier = (Magnifier){0};
    window->settings_chart.is_open = window->shows_settings = false;
    window->settings_end_time = 0;
    ray_view_reset(&window->ray_view);
}

void window_cycle_split(Window *window, int step) {
    update_text_now(window);
    set_split(window, (SplitMode)(((int)window->split.mode + step + SPLIT_COUNT) % SPLIT_COUNT));
    window->split.active = window->split.mode == SPLIT_BAR ? 1 : window->split.active;
}

bool window_awaits_frame(const Window *window) {
    const RayView *ray_view = &window->ray_view;
    return (window->split.mode != SPLIT_NONE && !window->viewports[1].renderer) ||
           (ray_view->is_open && ray_view->is_new);
}

void window_swap_active(Window *window) {
    update_text_now(window);
    window->split.active = 1 - window->split.active;
    window_present(window);
}

void window_move_bar(Window *window, double fraction) {
    split_view_move_bar(&window->split, fraction);
    window_present(window);
}

bool window_is_at_bar(const Window *window, double fraction) {
    return window->split.mode == SPLIT_BAR &&
           fabs(fraction - window->split.bar_position) < BAR_REACH;
}

void window_toggle_chart(Window *window) {
    settings_chart_panel_toggle(&window->settings_chart);
    window_present(window);
}

void window_toggle_magnifier(Window *window) {
    magnifier_toggle(&window->magnifier);
    window_present(window);
}

void window_toggle_settings(Window *window) {
    update_text_now(window);
    // A panel that came by itself is pinned.
    window->shows_settings = !window->shows_settings || window->settings_end_time > 0;
    window->settings_end_time = 0;
    window_present(window);
}

void window_end_settings(Window *window) {
    update_text_now(window);
    window->shows_settings = false;
    window->settings_end_time = 0;
}

/** Opens or closes the second viewport. @return false without memory: there is one viewport then.
 */
static bool update_second_viewport(Window *window, const Scene *scene, Error *error) {
    Viewport *first = &window->viewports[0], *second = &window->viewports[1];
    bool is_wanted = window->split.mode != SPLIT_NONE;
    if (!is_wanted && second->renderer) {
        viewport_close(second);
        split_view_deinit(&window->split);
    }
    if (!is_wanted || second->renderer) {
        return true;
    }
    if (!viewport_open(second, first, scene, &window->base_settings, window->pass_event, error)) {
        window->split.mode = SPLIT_NONE;
    }
    return second->renderer != NULL;
}

bool window_update_renderers(Window *window, const Scene *scene, Error *error) {
    bool ok = update_second_viewport(window, scene, error);
    for (size_t i = 0; i < window_viewport_count(window); i++) {
        if (window->viewports[i].needs_new_renderer) {
            ok = viewport_update_renderer(&window->viewports[i], scene, &window->base_settings,
                                          error) &&
                 ok;
            ray_view_on_renderer_changed(&window->ray_view);
        }
    }
    return ok;
}

/* --- events ----------------------------------------------------------------------------------- */

void window_on_pass(Window *window, const SDL_Event *event) {
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        if (event->user.data1 == &window->viewports[i] && window->viewports[i].renderer) {
            viewport_on_pass(&window->viewports[i]);
        }
    }
    ray_view_on_pass(&window->ray_view, event);
}

void window_on_visibility(Window *window) {
    Uint32 flags = SDL_GetWindowFlags(window->sdl.window);
    window->is_hidden = flags & (SDL_WINDOW_HIDDEN | SDL_WINDOW_MINIMIZED);
    for (size_t i = 0; window->is_hidden && i < window_viewport_count(window); i++) {
        if (viewport_stop(&window->viewports[i])) {
            latency_discard_pending(&window->latency);
        }
    }
    if (window->is_hidden) {
        ray_view_stop(&window->ray_view);
    }
}

bool window_on_resize(Window *window) {
    window_fold_large_toolbar(window);
    window->browser.scrolls = true; // What is selected stays in sight.
    window->fitted_height = window_used_height(window);
    SDL_Rect picture = window_picture_rect(window);
    bool is_other =
        picture.w != window->viewports[0].width || picture.h != window->viewports[0].height;
    if (is_other) {
        window_invalidate_text(window);
        window_invalidate(window);
    }
    window_present(window);
    if (window_fold_large_toolbar(window)) {
        window_on_resize(window); // In letters of the new size it was too large.
    }
    return is_other;
}

void window_on_device_reset(Window *window) {
    window_invalidate_text(window);
    gui_on_device_reset(window->gui);
    browser_release_textures(&window->browser);
    streaming_texture_release(&window->split.difference_texture);
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        streaming_texture_release(&window->viewports[i].texture);
        window->viewports[i].has_new_pass = window->viewports[i].renderer != NULL;
    }
    ray_view_release_textures(&window->ray_view);
}

/* --- text ------------------------------------------------------------------------------------- */

void window_invalidate_text(Window *window) {
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        hud_invalidate(&window->huds[i]);
    }
    ray_view_invalidate(&window->ray_view);
}

void window_scale_text(Window *window, int steps) {
    double scale = window->text_scale > 0 ? window->text_scale : 1;
    scale *= pow(TEXT_SCALE_STEP, steps);
    window->text_scale =
        steps == 0 ? 0 : SDL_clamp(scale, 1 / TEXT_SCALE_MAXIMUM, TEXT_SCALE_MAXIMUM);
    window_invalidate_text(window);
    window_relayout_toolbar(window);
}

void window_set_notice(Window *window, const char *text) {
    if (notice_set(&window->notice, text)) {
        window_present(window);
    }
}

/** Starts to render what has changed. @return false without memory. */
static bool start_invalidated(Window *window, const Scene *scene, double now, Error *error) {
    SDL_Rect picture = window_picture_rect(window);
    bool ok = true;
    for (size_t i = 0; i < window_viewport_count(window); i++) {
        Viewport *viewport = &window->viewports[i];
        if (viewport_is_start_due(viewport)) {
            latency_on_draw_started(&window->latency);
            ray_view_invalidate(&window->ray_view);
            ok = viewport_start(viewport, scene, picture.w, picture.h, now, error) && ok;
        }
    }
    return ok;
}

/** Shows the newest passes that are due. */
static void upload_due(Window *window, double now) {
    size_t count = window_viewport_count(window);
    bool has_uploaded = false;
    for (size_t i = 0; i < count; i++) {
        if (viewport_has_frame(&window->viewports[i], now)) {
            has_uploaded =
                viewport_upload(&window->viewports[i], window->sdl.renderer) || has_uploaded;
        }
    }
    if (!has_uploaded) {
        return;
    }
    if (count > 1 && window->split.mode == SPLIT_DIFFERENCE) {
        split_view_update_difference(&window->split, &window->viewports[0], &window->viewports[1],
                                     window->sdl.renderer);
    }
    window_present(window);
    double shown = clock_now_seconds();
    latency_on_presented(&window->latency, shown);
    if (window->first_present_time <= 0) {
        window->first_present_time = shown;
        window->opens_widgets = true;
    }
}

bool window_update(Window *window, const Scene *scene, double now, Error *error) {
    if (window->is_hidden) {
        return true;
    }
    SDL_Rect picture = window_picture_rect(window);
    if (picture.w != window->viewports[0].width || picture.h != window->viewports[0].height) {
        window_invalidate(window); // The bar has another height in a window of another width.
    }
    if (!start_invalidated(window, scene, now, error)) {
        return false;
    }
    upload_due(window, now);
    if (window->opens_widgets) {
        window->opens_widgets = false;
        window_icon_set(window->sdl.window); // After the first picture, which it would delay.
        window_open_widgets(window);
    }
    bool has_point =
        settings_chart_panel_update(&window->settings_chart, window_active_viewport(window), scene);
    if (window_widgets_are_due(window, now) || has_point) {
        window_present(window);
    }
    RayViewInput input = {window_active_viewport(window), scene, window->pass_event, now,
                          window_area(window)};
    bool ok = ray_view_update(&window->ray_view, &input, window->sdl.renderer, error);
    if (window->ray_view.needs_present) {
        window_present(window);
    }
    return ok;
}

double window_timeout(const Window *window, double now) {
    double delay = window->is_hidden ? WINDOW_NO_TIMEOUT : window_widgets_timeout(window, now);
    for (size_t i = 0; !window->is_hidden && i < window_viewport_count(window); i++) {
        delay = fmin(delay, viewport_timeout(&window->viewports[i], now));
    }
    if (window->ray_view.is_open && !window->is_hidden) {
        delay = fmin(delay, ray_view_timeout(&window->ray_view, now));
    }
    return delay;
}

bool window_is_ready(const Window *window) {
    bool is_ready = false;
    for (size_t i = 0; i < window_viewport_count(window); i++) {
        is_ready = is_ready || !window->viewports[i].awaits_first_frame;
    }
    return is_ready && !window->is_hidden;
}

bool window_is_finished(const Window *window) {
    bool is_finished = true;
    for (size_t i = 0; i < window_viewport_count(window); i++) {
        is_finished = is_finished && viewport_is_finished(&window->viewports[i]);
    }
    return is_finished;
}
