/**
 * @file
 * @brief Composing viewports and panels.
 */
#include "view/window.h"

#include "base/language.h"
#include "view/panels/picture_unrest.h"
#include "view/state/snapshot.h"
#include "view/window/window_icon.h"

#include <libintl.h>
#include <stdlib.h>

/** Factor of the size of letters per step. */
static const double TEXT_SCALE_STEP = 1.2;
/** Largest factor of the size of letters; the smallest is its inverse. */
static const double TEXT_SCALE_MAXIMUM = 3;

/** How much calmer the other edge must be until a caption goes there. */
static const double UNREST_RATIO = 1.5;
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
    window->base_settings = *settings;
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

void window_override_setting(Window *window, SettingsChangeFn *change, int step) {
    update_text_now(window);
    if (!window->shows_settings || window->settings_end_time > 0) {
        window->settings_end_time = clock_now_seconds() + SETTINGS_SECONDS;
    }
    window->shows_settings = true;
    viewport_override_setting(window_active_viewport(window), &window->base_settings, change, step);
}

void window_request_new_renderers(Window *window) {
    for (size_t i = 0; i < window_viewport_count(window); i++) {
        window->viewports[i].needs_new_renderer = true;
    }
}

void window_reset_overrides(Window *window) {
    update_text_now(window);
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        Viewport *viewport = &window->viewports[i];
        viewport->overrides = (SettingsOverride){0};
        viewport->needs_new_renderer = true;
        if (viewport->renderer) {
            viewport_set_layer(viewport, LAYER_SHADED);
        } else {
            viewport->layer = LAYER_SHADED;
        }
    }
    window->split.mode = SPLIT_NONE;
    split_view_move_bar(&window->split, 0.5);
}

void window_cycle_split(Window *window, int step) {
    update_text_now(window);
    window->split.mode = (SplitMode)(((int)window->split.mode + step + SPLIT_COUNT) % SPLIT_COUNT);
    window->split.active = window->split.mode == SPLIT_BAR ? 1 : window->split.active;
    for (size_t i = 0; i < WINDOW_VIEWPORTS; i++) {
        window->viewports[i].has_new_pass = window->viewports[i].renderer != NULL;
    }
}

bool window_awaits_second_picture(const Window *window) {
    return window->split.mode != SPLIT_NONE && !window->viewports[1].renderer;
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
    window->fitted_height = window_used_height(window);
    SDL_Rect picture = window_picture_rect(window);
    bool is_other =
        picture.w != window->viewports[0].width || picture.h != window->viewports[0].height;
    if (is_other) {
        window_invalidate_text(window);
        window_invalidate(window);
    }
    window_present(window);
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

/* --- showing ---------------------------------------------------------------------------------- */

/** Draws the viewports. */
static void draw_viewports(Window *window) {
    SDL_Renderer *renderer = window->sdl.renderer;
    SDL_Rect rect = window_picture_rect(window), clip = rect;
    if (window_viewport_count(window) == 1) {
        streaming_texture_draw(&window->viewports[0].texture, renderer, &rect, &clip);
    } else if (window->split.mode == SPLIT_DIFFERENCE) {
        streaming_texture_draw(&window->split.difference_texture, renderer, &rect, &clip);
    } else {
        clip.w = split_view_column(&window->split, rect.w);
        streaming_texture_draw(&window->viewports[0].texture, renderer, &rect, &clip);
        clip.x += clip.w;
        clip.w = rect.w - clip.w;
        streaming_texture_draw(&window->viewports[1].texture, renderer, &rect, &clip);
        split_view_draw_bar(&window->split, renderer, &rect);
    }
}

/** Shows the panels on the viewports, in the upper corners of an area. @param[out] extents Where
 *  they lie. */
static void show_huds(Window *window, const GuiRect *area, GuiRect extents[WINDOW_VIEWPORTS]) {
    static const char *const ids[WINDOW_VIEWPORTS] = {"panel 1", "panel 2"};
    static const char *const titles[2][WINDOW_VIEWPORTS] = {{N_("left"), N_("right")},
                                                            {N_("left ←"), N_("right ←")}};
    size_t count = window_viewport_count(window);
    for (size_t i = 0; i < count; i++) {
        bool is_active = window->split.active == i;
        HudContent content = {.viewport = &window->viewports[i],
                              .title = count > 1 ? titles[is_active][i] : NULL,
                              .shows_settings = window->shows_settings};
        hud_update(&window->huds[i], &content, clock_now_seconds());
        GuiPlace place = {*area, (float)i, 0};
        place.room.width = area->width / (float)count;
        place.room.x += (float)i * place.room.width;
        extents[i] = hud_show(&window->huds[i], ids[i], &place);
    }
}

/** Chooses the edge of the picture at which the caption hides least. @param room The room for it,
 *  @param is_top_free Whether nothing else lies at the upper edge. */
static void choose_caption_edge(Window *window, const GuiRect *room, bool is_top_free) {
    Caption *caption = &window->caption;
    double part = (double)(caption_height(caption, room->width) / SDL_max(1, room->height));
    double above = picture_unrest(&window->viewports[0], 0, part);
    double below = picture_unrest(&window->viewports[0], 1 - part, 1);
    double favour = caption->is_above ? UNREST_RATIO : 1 / UNREST_RATIO;
    caption->is_above = is_top_free && above < below * favour;
}

float window_show_panels(Window *window, const GuiRect *area) {
    GuiRect extents[WINDOW_VIEWPORTS] = {{0}};
    GuiRect room = *area;
    if (!window->ray_view.is_open) {
        show_huds(window, area, extents);
    }
    float notice = notice_show(&window->notice, &room);
    room.height = SDL_max(1, room.height - notice);
    if (caption_is_open(&window->caption)) {
        choose_caption_edge(window, &room, extents[0].height <= 0 && !window->ray_view.is_open);
    }
    GuiRect caption = caption_show(&window->caption, &room);
    bool is_below = caption.height > 0 && !window->caption.is_above;
    return is_below ? caption.y : room.y + room.height;
}

/** Draws the pictures. */
static void draw_pictures(Window *window) {
    SDL_Rect area = window_area(window);
    sdl_window_clear(&window->sdl);
    if (window->ray_view.is_open && !window->help.is_open) {
        ray_view_show(&window->ray_view, &window_active_viewport(window)->texture,
                      window->sdl.renderer, &area);
    } else {
        draw_viewports(window);
    }
}

void window_present(Window *window) {
    draw_pictures(window);
    window_show_widgets(window);
    sdl_window_present(&window->sdl);
}

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
        if (viewport->needs_restart && !viewport->awaits_first_frame) {
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
    bool has_point = settings_chart_panel_update(&window->settings_chart,
                                                 window_active_viewport(window), scene);
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

/** Copies the picture on screen. @param[out] bgrx See #split_view_compose. @return false without
 * memory. */
static bool copy_pixels(Window *window, uint8_t *bgrx, int pitch) {
    RenderStats report;
    return window_viewport_count(window) > 1
               ? split_view_compose(&window->split, &window->viewports[0], &window->viewports[1],
                                    bgrx, pitch)
               : renderer_copy_latest(window->viewports[0].renderer, &report, bgrx, pitch);
}

/** Makes a picture of pixels of the screen. @param bgrx The pixels, freed here; NULL: there are
 * none.
 *  @return Whether it is made. */
static bool picture_from_screen(uint8_t *bgrx, int width, int height, Picture *picture,
                                Error *error) {
    if (!bgrx) {
        return error_set(error, STATUS_FAILED, "no memory for a snapshot");
    }
    bool is_made = picture_init(picture, width, height, error);
    if (is_made) {
        snapshot_from_bgrx(bgrx, picture);
    }
    free(bgrx);
    return is_made;
}

void window_copy_part(const Window *window, int x, int y, int columns, int rows, uint8_t *rgb) {
    const SplitView *split = &window->split;
    const Viewport *first = &window->viewports[0];
    if (window_viewport_count(window) == 1) {
        renderer_copy_part(first->renderer, x, y, columns, rows, rgb);
    } else if (split->mode == SPLIT_DIFFERENCE) {
        split_view_copy_part(split, x, y, columns, rows, rgb);
    } else {
        int right = split_view_column(split, first->width);
        for (int column = x; column < x + columns; column++) {
            Renderer *renderer = window->viewports[column >= right ? 1 : 0].renderer;
            for (int row = y; row < y + rows; row++) {
                uint8_t *pixel = rgb + 3 * ((row - y) * columns + column - x);
                renderer_copy_part(renderer, column, row, 1, 1, pixel);
            }
        }
    }
}

bool window_copy_screen(Window *window, Picture *picture, Error *error) {
    SDL_Rect area = window_area(window);
    size_t row = (size_t)area.w * 4;
    uint8_t *bgrx = malloc(row * (size_t)area.h);
    draw_pictures(window);
    window_show_panels_alone(window);
    if (bgrx && SDL_RenderReadPixels(window->sdl.renderer, &area, SDL_PIXELFORMAT_XRGB8888, bgrx,
                                     (int)row) != 0) {
        free(bgrx);
        return error_set(error, STATUS_FAILED, "the screen cannot be read: %s", SDL_GetError());
    }
    return picture_from_screen(bgrx, area.w, area.h, picture, error);
}

bool window_copy_picture(Window *window, Picture *picture, Error *error) {
    int width = window->viewports[0].width, height = window->viewports[0].height;
    size_t row = (size_t)width * 4;
    uint8_t *bgrx = malloc(row * (size_t)height);
    if (bgrx && !copy_pixels(window, bgrx, (int)row)) {
        free(bgrx);
        bgrx = NULL;
    }
    return picture_from_screen(bgrx, width, height, picture, error);
}
