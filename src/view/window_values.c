/**
 * @file
 * @brief Values over the picture: legends, rings around artefacts, the magnifier, the chart.
 */
#include "render/rounding_witness.h"
#include "view/panels/legend.h"
#include "view/panels/pixel_readout.h"
#include "view/window_internal.h"

/** Radius of a ring, in heights of letters. */
static const float RING_RADIUS = 0.8F;
/** Radius of the ring around the pixel that is magnified, in heights of letters. */
static const float MAGNIFIED_RADIUS = 0.5F;
/** Least room below a legend for the readout of one picture and of two, in heights of letters. */
static const float READOUT_ROOMS[WINDOW_VIEWPORTS] = {2, 5};

/** Usual width of a legend of one picture and of two, fraction of the window's: with two, each has
 *  half of the window, and the place where they meet is what is compared. */
static const float LEGEND_WIDTHS[WINDOW_VIEWPORTS] = {0.45F, 0.25F};

/* --- where things are ------------------------------------------------------------------------- */

/** @return The picture's rectangle, screen units. */
static SDL_Rect picture_units(const Window *window) {
    return window_to_units(window, window_picture_rect(window));
}

/** @return Whether the difference of two pictures is on screen. */
static bool is_difference_shown(const Window *window) {
    return window_viewport_count(window) > 1 && window->split.mode == SPLIT_DIFFERENCE;
}

bool window_is_right_side(const Window *window, int column) {
    return window_viewport_count(window) > 1 && window->split.mode == SPLIT_BAR &&
           column >= split_view_column(&window->split, window->viewports[0].width);
}

SDL_Rect window_area_beside_inspector(const Window *window) {
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

/* --- legends ---------------------------------------------------------------------------------- */

/** @return Number of legends: the difference of two pictures has one. */
static size_t legend_count(const Window *window) {
    return is_difference_shown(window) ? 1 : window_viewport_count(window);
}

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
    const size_t count = legend_count(window);
    const float gap =
        fmaxf(READOUT_ROOMS[window_viewport_count(window) - 1] * gui_text_size(), readout_height);
    const GuiLegendPlace place = {.corner = {(float)(is_right ? area->x + area->w : area->x),
                                             (float)(area->y + area->h) - gap},
                                  .highest = (float)area->h - gap,
                                  .usual =
                                      LEGEND_WIDTHS[count - 1] * window_area_units(window).width,
                                  .widest = (float)area->w / (float)count,
                                  .is_right = is_right,
                                  .taken = window->hud_rects,
                                  .taken_count = WINDOW_VIEWPORTS};
    return gui_legend(is_right ? "legend right" : "legend left", &drawn, &place);
}

/** Shows the legend of each picture, or that of their difference. */
static void show_legends(Window *window) {
    const Readout *readout = &window->readout;
    const float readout_height = readout->is_shown && !readout->is_above ? readout->rect.height : 0;
    SDL_Rect area = window_area_beside_inspector(window);
    bool is_difference = is_difference_shown(window);
    const size_t count = legend_count(window);
    bool is_right = count == 1 && !window->settings_chart.is_open; // The chart lies at the right.
    if (window->settings_chart.is_open) {
        area.w -= (int)ceilf(settings_chart_panel_width((float)area.w));
    }
    for (size_t i = 0; i < count; i++) {
        const Viewport *viewport = &window->viewports[i];
        Legend legend;
        LegendContent content = {.scene = window->state.scene,
                                 .report = &viewport->report,
                                 .settings = &viewport->settings,
                                 .marks = &viewport->marks,
                                 .difference = is_difference ? &window->split.difference : NULL,
                                 .progress = renderer_progress(viewport->renderer),
                                 .cannot_round = !rounding_is_supported()};
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
    const PixelPosition *pixel = &window->magnifier.pixel;
    const PixelReadout *readout = &window->readout.pixel;
    uint8_t rgb[3 * MAGNIFIER_PIXELS * MAGNIFIER_PIXELS] = {0};
    char caption[READOUT_SIZE];
    if (!window->magnifier.is_on || !window->readout.is_read) {
        return;
    }
    int reach = MAGNIFIER_PIXELS / 2, x = pixel->x - reach, y = pixel->y - reach;
    window_copy_part(window, x, y, MAGNIFIER_PIXELS, MAGNIFIER_PIXELS, rgb);
    size_t side = window_is_right_side(window, pixel->x) ? 1 : 0;
    if (is_difference_shown(window)) {
        pixel_readout_difference(readout->readings, caption);
    } else {
        pixel_readout_value(readout, side, caption);
    }
    GuiPixels pixels = {rgb, MAGNIFIER_PIXELS, MAGNIFIER_PIXELS, caption};
    const GuiPoint point = window_pixel_place(window, pixel);
    gui_ring(point, MAGNIFIED_RADIUS * gui_text_size());
    const GuiRect area = window_area_beside_readout(window, window_area_units(window));
    gui_pixels(&pixels, point, area.y, area.y + area.height);
}

/** Shows the chart of settings, if it is open. */
static void show_chart(const Window *window) {
    if (window->settings_chart.is_open) {
        SDL_Rect area = window_area_beside_inspector(window);
        size_t active = window_viewport_count(window) > 1 ? window->split.active : 0;
        const GuiRect free = window_area_beside_readout(
            window, (GuiRect){(float)area.x, (float)area.y, (float)area.w, (float)area.h});
        area.y = (int)ceilf(free.y);
        area.h = SDL_max(1, (int)floorf(free.height));
        settings_chart_panel_show(&window->settings_chart, &window->viewports[active], &area);
    }
}

void window_show_values(Window *window) {
    memset(window->legend_rects, 0, sizeof window->legend_rects);
    if (window_picture_is_shown(window)) {
        show_all_rings(window);
        show_legends(window);
        show_magnifier(window);
        show_chart(window);
    }
}
