/**
 * @file
 * @brief Composing two pictures, and their bar.
 */
#include "view/window/split_view.h"

#include <stdlib.h>
#include <string.h>

/** Margin of the bar at both ends of the picture, fraction of its width. */
static const double BAR_MARGIN = 0.02;

void split_view_deinit(SplitView *split) {
    streaming_texture_release(&split->difference_texture);
    free(split->pixels);
    free(split->values);
    split->pixels = NULL;
    split->values = NULL;
    split->pixel_capacity = split->value_capacity = 0;
}

int split_view_column(const SplitView *split, int width) {
    return (int)(split->bar_position * width + 0.5);
}

void split_view_move_bar(SplitView *split, double fraction) {
    split->bar_position = SDL_clamp(fraction, BAR_MARGIN, 1 - BAR_MARGIN);
}

/** Copies the newest passes of both viewports. @param[out] layers Their layers. @return false
 *  without memory, or while one has no pass. */
static bool copy_both(SplitView *split, const Viewport *left, const Viewport *right,
                      Layer layers[2]) {
    size_t pixels = (size_t)left->width * (size_t)left->height;
    if (left->width != right->width || left->height != right->height) {
        return false;
    }
    if (split->pixel_capacity < pixels) {
        free(split->pixels);
        split->pixels = malloc(2 * 4 * pixels);
        split->pixel_capacity = split->pixels ? pixels : 0;
    }
    split->width = left->width;
    split->height = left->height;
    RenderStats reports[2];
    int pitch = 4 * left->width;
    bool is_copied =
        split->pixels && renderer_copy_latest(left->renderer, &reports[0], split->pixels, pitch) &&
        renderer_copy_latest(right->renderer, &reports[1], split->pixels + 4 * pixels, pitch);
    for (int i = 0; is_copied && i < 2; i++) {
        layers[i] = reports[i].layer.layer;
    }
    return is_copied;
}

/** Copies the numbers of both layers. @return false without memory, or while one has none. */
static bool copy_both_values(SplitView *split, const Viewport *left, const Viewport *right) {
    size_t pixels = (size_t)left->width * (size_t)left->height;
    if (split->value_capacity < pixels) {
        free(split->values);
        split->values = malloc(2 * LAYER_VALUES * pixels * sizeof *split->values);
        split->value_capacity = split->values ? pixels : 0;
    }
    RenderStats report;
    return split->values && renderer_copy_values(left->renderer, &report, split->values) &&
           renderer_copy_values(right->renderer, &report, split->values + LAYER_VALUES * pixels);
}

/** Draws the difference over the first of both pictures. @param layers Their layers. @return false
 *  without memory. */
static bool draw_difference(SplitView *split, const Viewport *left, const Viewport *right,
                            const Layer layers[2]) {
    size_t pixels = (size_t)left->width * (size_t)left->height;
    if (layers[0] != layers[1]) {
        split->difference = difference_map_draw_none(pixels, split->pixels);
        return true;
    }
    if (layers[0] == LAYER_SHADED) {
        split->difference =
            difference_map_draw(split->pixels, split->pixels + 4 * pixels, pixels, split->pixels);
        return true;
    }
    bool has_values = copy_both_values(split, left, right);
    if (has_values) {
        split->difference = difference_map_draw_values(
            layers[0], split->values, split->values + LAYER_VALUES * pixels, pixels, split->pixels);
    }
    return has_values;
}

bool split_view_compose(SplitView *split, const Viewport *left, const Viewport *right,
                        uint8_t *bgrx, int pitch) {
    Layer layers[2];
    if (!copy_both(split, left, right, layers)) {
        return false;
    }
    size_t row = 4 * (size_t)left->width, picture_bytes = row * (size_t)left->height;
    const uint8_t *a = split->pixels, *b = split->pixels + picture_bytes;
    if (split->mode == SPLIT_DIFFERENCE && !draw_difference(split, left, right, layers)) {
        return false;
    }
    bool is_bar = split->mode == SPLIT_BAR;
    size_t left_bytes = is_bar ? 4 * (size_t)split_view_column(split, left->width) : row;
    for (int y = 0; y < left->height; y++, a += row, b += row) {
        uint8_t *destination = bgrx + (ptrdiff_t)y * pitch;
        memcpy(destination, a, left_bytes);
        memcpy(destination + left_bytes, b + left_bytes, row - left_bytes);
    }
    return true;
}

void split_view_update_difference(SplitView *split, const Viewport *left, const Viewport *right,
                                  SDL_Renderer *renderer) {
    int pitch = 0;
    uint8_t *pixels = streaming_texture_lock(&split->difference_texture, renderer, left->width,
                                             left->height, &pitch);
    if (pixels) {
        if (!split_view_compose(split, left, right, pixels, pitch)) {
            memset(pixels, 0, (size_t)pitch * (size_t)left->height); // Not what lay there before.
        }
        streaming_texture_unlock(&split->difference_texture);
    }
}

void split_view_copy_part(const SplitView *split, int x, int y, int columns, int rows,
                          uint8_t *rgb) {
    for (int i = 0; split->pixels && i < columns * rows; i++) {
        int column = x + i % columns, row = y + i / columns;
        if (column >= 0 && column < split->width && row >= 0 && row < split->height) {
            const uint8_t *bgrx =
                split->pixels + 4 * ((size_t)row * (size_t)split->width + (size_t)column);
            for (int channel = 0; channel < 3; channel++) {
                rgb[3 * i + channel] = bgrx[2 - channel];
            }
        }
    }
}

void split_view_draw_bar(const SplitView *split, SDL_Renderer *renderer, const SDL_Rect *picture) {
    int thick = SDL_max(1, picture->h / 400), x = picture->x + split_view_column(split, picture->w);
    // Dark beside light: visible on any picture.
    SDL_Rect dark = {x - 2 * thick, picture->y, 4 * thick, picture->h},
             light = {x - thick, picture->y, 2 * thick, picture->h};
    SDL_SetRenderDrawColor(renderer, 0, 0, 0, SDL_ALPHA_OPAQUE);
    SDL_RenderFillRect(renderer, &dark);
    SDL_SetRenderDrawColor(renderer, UINT8_MAX, UINT8_MAX, UINT8_MAX, SDL_ALPHA_OPAQUE);
    SDL_RenderFillRect(renderer, &light);
}
