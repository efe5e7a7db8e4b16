/**
 * @file
 * @brief Values over the picture: legends, rings around artefacts, the pixel under the mouse.
 */
#include "view/panels/legend.h"
#include "view/panels/pixel_readout.h"
#include "view/window_internal.h"

/** Radius of a ring, in heights of letters. */
static const float RING_RADIUS = 0.8F;
/** Radius of the ring around the pixel that is magnified, in heights of letters. */
static const float MAGNIFIED_RADIUS = 0.5F;
/** Least room below a legend for the readout of one picture and of two, in heights of letters. */
static const float READOUT_ROOMS[WINDOW_VIEWPORTS] = {2, 5};

/* --- where things are ------------------------------------------------------------------------- */

/** @return The picture's rectangle, screen units. */
static SDL_Rect picture_units(const Window *window) {
    return window_to_units(window, window_picture_rect(window));
}

/** @return Whether the picture is on screen, and nothing lies over it. */
static bool is_picture_shown(const Window *window) {
    return !window->help.is_open && !window->browser.is_open && !window->ray_view.is_open;
}

/** @return Whether the difference of two pictures is on screen. */
static bool is_difference_shown(const Window *window) {
    return window_viewport_count(window) > 1 && window->split.mode == SPLIT_DIFFERENCE;
}

/** @return Whether a column shows the right one of two pictures. */
static bool is_right_side(const Window *window, int column) {
    return window_viewport_count(window) > 1 && window->split.mode == SPLIT_BAR &&
           column >= split_view_column(&window->split, window->viewports[0].width);
}

/** Finds the pixel under the mouse. @return false if the mouse is not on the picture. */
static bool pixel_under_mouse(const Window *window, PixelPosition *pixel) {
    const Viewport *viewport = &window->viewports[0];
    int x = 0, y = 0;
    double right, down;
    SDL_GetMouseState(&x, &y);
    if (SDL_GetMouseFocus() != window->sdl.window ||
        !window_picture_position(window, x, y, &right, &down)) {
        return false;
    }
    *pixel = (PixelPosition){(int)(right * viewport->width), (int)(down * viewport->height)};
    return true;
}

bool window_named_pixel(const Window *window, PixelPosition *pixel) {
    if (!window->gui || !is_picture_shown(window)) {
        return false;
    }
    if (window->magnifier.is_on && window->magnifier.has_place) {
        *pixel = window->magnifier.pixel;
        return true;
    }
    return !gui_has_mouse() && pixel_under_mouse(window, pixel);
}

/** @return The part of the window for a panel beside the inspector, screen units: the wider side.
 */
static SDL_Rect area_beside_inspector(const Window *window) {
    SDL_Rect area = window_to_units(window, window_area(window));
    GuiRect inspector = gui_inspector_rect();
    int from = (int)inspector.x, to = (int)(inspector.x + inspector.width);
    if (inspector.width > 0 && from - area.x >= area.x + area.w - to) {
        area.w = SDL_max(1, from - area.x);
    } else if (inspector.width > 0) {
        area.w = SDL_max(1, area.x + area.w - to);
        area.x = to;
    }
    return area;
}

/* --- what a pixel shows ----------------------------------------------------------------------- */

/** Reads a pixel of all pictures. @return false if one has no pass yet. */
static bool read_pixels(const Window *window, int x, int y, PixelReadout *readout) {
    *readout = (PixelReadout){
        .scene = window->state.scene, .x = x, .y = y, .is_magnified = window->magnifier.is_on};
    for (size_t i = 0; i < window_viewport_count(window); i++) {
        Renderer *renderer = window->viewports[i].renderer;
        if (!renderer || !renderer_read_pixel(renderer, x, y, &readout->readings[i])) {
            return false;
        }
        readout->count++;
    }
    readout->samples = window->viewports[0].report.samples;
    return true;
}

/** Writes what the pixel shows that is named. @return Whether the readout is to be shown. */
static bool write_readout(const Window *window, PixelReadout *readout, char text[READOUT_SIZE]) {
    PixelPosition pixel;
    // It would cover a part of what a question is about.
    bool is_in_the_way = window->toolbar.is_folded || window->lesson_panel.is_asking;
    bool is_wanted = window->magnifier.is_on || !is_in_the_way;
    if (!is_wanted || window->hint.text[0] != '\0' || !window_named_pixel(window, &pixel) ||
        !read_pixels(window, pixel.x, pixel.y, readout)) {
        return false;
    }
    pixel_readout_write(readout, text);
    return true;
}

/* --- legends ---------------------------------------------------------------------------------- */

/** Draws the legend of a viewport. @param area The window without its bar, screen units. @return
 *  Where it lies. */
static GuiRect draw_legend(const Window *window, const Legend *legend, const SDL_Rect *area,
                           float readout_height, bool is_right) {
    GuiSwatch swatches[LEGEND_ENTRIES_MAXIMUM];
    const char *notes[LEGEND_NOTES];
    for (size_t i = 0; i < legend->entry_count; i++) {
        swatches[i] =
            (GuiSwatch){.position = (float)legend->entries[i].position, .text = legend->texts[i]};
        memcpy(swatches[i].rgb, legend->entries[i].rgb, sizeof swatches[i].rgb);
    }
    for (size_t i = 0; i < legend->note_count; i++) {
        notes[i] = legend->notes[i];
    }
    GuiLegend drawn = {.title = legend->title,
                       .unit = legend->unit,
                       .bar = legend->bar,
                       .bar_count = legend->has_bar ? LEGEND_BAR_COLORS : 0,
                       .swatches = swatches,
                       .swatch_count = (int)legend->entry_count,
                       .notes = notes,
                       .note_count = (int)legend->note_count};
    const float gap =
        fmaxf(READOUT_ROOMS[window_viewport_count(window) - 1] * gui_text_size(), readout_height);
    const GuiLegendPlace place = {.corner = {(float)(is_right ? area->x + area->w : area->x),
                                             (float)(area->y + area->h) - gap},
                                  .highest = (float)area->h - gap,
                                  .widest = (float)area->w,
                                  .is_right = is_right,
                                  .taken = window->hud_rects,
                                  .taken_count = WINDOW_VIEWPORTS};
    return gui_legend(is_right ? "legend right" : "legend left", &drawn, &place);
}

/** Shows the legend of each picture, or that of their difference. @param readout_height Room that
 *  the readout takes below them, screen units. */
static void show_legends(Window *window, float readout_height) {
    SDL_Rect area = area_beside_inspector(window);
    bool is_difference = is_difference_shown(window);
    size_t count = is_difference ? 1 : window_viewport_count(window);
    bool is_right = count == 1 && !window->settings_chart.is_open; // The chart lies at the right.
    for (size_t i = 0; i < count; i++) {
        const Viewport *viewport = &window->viewports[i];
        Legend legend;
        LegendContent content = {.scene = window->state.scene,
                                 .report = &viewport->report,
                                 .settings = &viewport->settings,
                                 .marks = &viewport->marks,
                                 .difference = is_difference ? &window->split.difference : NULL,
                                 .progress = renderer_progress(viewport->renderer)};
        legend_write(&content, &legend);
        if (legend.title[0] != '\0') {
            window->legend_rects[i] =
                draw_legend(window, &legend, &area, readout_height, is_right || i == 1);
        }
    }
}

/* --- rings ------------------------------------------------------------------------------------ */

/** Shows rings around the artefacts of a picture. @param columns Those that are seen of it: the
 *  first one, and the one after the last. */
static void show_rings(const Window *window, const Viewport *viewport, const int columns[2]) {
    SDL_Rect picture = picture_units(window);
    for (size_t i = 0; i < viewport->marks.count; i++) {
        int x = viewport->marks.x[i], y = viewport->marks.y[i];
        double right = (x + 0.5) / viewport->width, down = (y + 0.5) / viewport->height;
        if (x >= columns[0] && x < columns[1]) {
            gui_ring((GuiPoint){(float)(picture.x + right * picture.w),
                                (float)(picture.y + down * picture.h)},
                     RING_RADIUS * gui_text_size());
        }
    }
}

/** Shows rings around the artefacts of all pictures that are seen. */
static void show_all_rings(const Window *window) {
    int width = window->viewports[0].width;
    if (window_viewport_count(window) == 1) {
        show_rings(window, &window->viewports[0], (const int[]){0, width});
    } else if (!is_difference_shown(window)) {
        int bar = split_view_column(&window->split, width);
        show_rings(window, &window->viewports[0], (const int[]){0, bar});
        show_rings(window, &window->viewports[1], (const int[]){bar, width});
    }
}

/* --- one pixel -------------------------------------------------------------------------------- */

/** Draws a pixel of the magnifier, with those around it. */
static void show_magnifier(const Window *window) {
    const Viewport *viewport = &window->viewports[0];
    const PixelPosition *pixel = &window->magnifier.pixel;
    uint8_t rgb[3 * MAGNIFIER_PIXELS * MAGNIFIER_PIXELS] = {0};
    char caption[READOUT_SIZE];
    PixelReadout readout;
    if (!window->magnifier.is_on || !read_pixels(window, pixel->x, pixel->y, &readout)) {
        return;
    }
    int reach = MAGNIFIER_PIXELS / 2, x = pixel->x - reach, y = pixel->y - reach;
    window_copy_part(window, x, y, MAGNIFIER_PIXELS, MAGNIFIER_PIXELS, rgb);
    size_t side = is_right_side(window, pixel->x) ? 1 : 0;
    if (is_difference_shown(window)) {
        pixel_readout_difference(readout.readings, caption);
    } else {
        pixel_readout_value(&readout.readings[side], caption);
    }
    GuiPixels pixels = {rgb, MAGNIFIER_PIXELS, MAGNIFIER_PIXELS, caption};
    SDL_Rect picture = picture_units(window);
    GuiPoint point = {(float)(picture.x + (pixel->x + 0.5) / viewport->width * picture.w),
                      (float)(picture.y + (pixel->y + 0.5) / viewport->height * picture.h)};
    gui_ring(point, MAGNIFIED_RADIUS * gui_text_size());
    char text[READOUT_SIZE];
    pixel_readout_write(&readout, text);
    SDL_Rect area = window_to_units(window, window_area(window));
    gui_pixels(&pixels, point, (float)area.y, (float)(area.y + area.h) - gui_readout_height(text));
}

void window_follow_mouse(Window *window) {
    PixelPosition mouse;
    const Viewport *viewport = &window->viewports[0];
    bool is_there = pixel_under_mouse(window, &mouse);
    magnifier_follow(&window->magnifier, is_there ? &mouse : NULL, SDL_max(1, viewport->width),
                     SDL_max(1, viewport->height));
}

float window_show_readout(const Window *window) {
    PixelReadout readout;
    char text[READOUT_SIZE];
    GuiRect area = window_area_units(window);
    const float bottom = area.y + area.height;
    if (!write_readout(window, &readout, text)) {
        return bottom;
    }
    size_t side = is_right_side(window, readout.x) ? 1 : 0;
    gui_readout("readout", text, readout.readings[side].rgb, (GuiPoint){area.x, bottom});
    return bottom - gui_readout_height(text);
}

/** Shows the chart of settings, if it is open. @param readout_height Room that the readout takes
 *  below it, screen units. */
static void show_chart(const Window *window, float readout_height) {
    if (window->settings_chart.is_open) {
        SDL_Rect area = area_beside_inspector(window);
        size_t active = window_viewport_count(window) > 1 ? window->split.active : 0;
        area.h = SDL_max(1, area.h - (int)ceilf(readout_height));
        settings_chart_panel_show(&window->settings_chart, &window->viewports[active], &area);
    }
}

void window_show_values(Window *window) {
    memset(window->legend_rects, 0, sizeof window->legend_rects);
    if (is_picture_shown(window)) {
        PixelReadout readout;
        char text[READOUT_SIZE];
        float readout_height = write_readout(window, &readout, text) ? gui_readout_height(text) : 0;
        show_all_rings(window);
        show_legends(window, readout_height);
        show_magnifier(window);
        show_chart(window, readout_height);
    }
}
