/**
 * @file
 * @brief The screen: drawing pictures and widgets, and copies of what is seen.
 */
#include "view/state/snapshot.h"
#include "view/window_internal.h"

#include <stdlib.h>

/* --- drawing ------------------------------------------------------------------------------------
 */

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

void window_draw_pictures(Window *window) {
    SDL_Rect area = window_area(window);
    sdl_window_clear(&window->sdl);
    if (window->ray_view.is_open && !window->help.is_open) {
        ray_view_show(&window->ray_view, &window_active_viewport(window)->texture,
                      window->sdl.renderer, &area);
    } else {
        draw_viewports(window);
        if (window->ray_view.is_marked) {
            const SDL_Rect picture = window_picture_rect(window);
            ray_view_show_mark(&window->ray_view, window->sdl.renderer, &picture);
        }
    }
}

void window_present(Window *window) {
    window_draw_pictures(window);
    window_show_widgets(window);
    sdl_window_present(&window->sdl);
}

/* --- copies -------------------------------------------------------------------------------------
 */

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
    window_draw_pictures(window);
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
