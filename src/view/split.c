/**
 * @file
 * @brief Two pictures in one window.
 */
#include "view/split.h"

#include <stdlib.h>
#include <string.h>

/** Share of the window at its left and right end where the bar does not go. */
static const double MARGIN = 0.02;

void split_release(Split *split) {
    canvas_forget(&split->canvas);
    free(split->pixels);
    split->pixels = NULL;
    split->room = 0;
}

int split_column(const Split *split, int width) {
    return (int)(split->bar * width + 0.5);
}

void split_move(Split *split, double share) {
    split->bar = SDL_clamp(share, MARGIN, 1 - MARGIN);
}

/** Takes what both sights have drawn. @param[in,out] split The split. @param left The left one.
 *  @param right The right one. @return false without memory, or while one has drawn nothing. */
static bool take_both(Split *split, const Sight *left, const Sight *right) {
    size_t pixels = (size_t)left->width * (size_t)left->height;
    if (left->width != right->width || left->height != right->height) {
        return false;
    }
    if (split->room < pixels) {
        free(split->pixels);
        split->pixels = malloc(2 * 4 * pixels);
        split->room = split->pixels ? pixels : 0;
    }
    RenderReport report;
    int pitch = 4 * left->width;
    return split->pixels && renderer_take(left->renderer, &report, split->pixels, pitch) &&
           renderer_take(right->renderer, &report, split->pixels + 4 * pixels, pitch);
}

bool split_compose(Split *split, const Sight *left, const Sight *right, uint8_t *bgrx, int pitch) {
    if (!take_both(split, left, right)) {
        return false;
    }
    size_t row = 4 * (size_t)left->width, all = row * (size_t)left->height;
    const uint8_t *a = split->pixels, *b = split->pixels + all;
    if (split->mode == SPLIT_DIFFERENCE) {
        split->difference = difference_draw(a, b, all / 4, split->pixels);
    }
    bool is_bar = split->mode == SPLIT_BAR;
    size_t own = is_bar ? 4 * (size_t)split_column(split, left->width) : row;
    for (int y = 0; y < left->height; y++, a += row, b += row) {
        uint8_t *to = bgrx + (ptrdiff_t)y * pitch;
        memcpy(to, a, own);
        memcpy(to + own, b + own, row - own);
    }
    return true;
}

void split_subtract(Split *split, const Sight *left, const Sight *right, SDL_Renderer *renderer) {
    int pitch = 0;
    uint8_t *pixels = canvas_lock(&split->canvas, renderer, left->width, left->height, &pitch);
    if (pixels) {
        split_compose(split, left, right, pixels, pitch);
        canvas_unlock(&split->canvas);
    }
}

void split_show_bar(const Split *split, SDL_Renderer *renderer) {
    int width = 0, height = 0;
    SDL_GetRendererOutputSize(renderer, &width, &height);
    int thick = SDL_max(1, height / 400), x = split_column(split, width);
    // Dark beside light: it is seen on any picture.
    SDL_Rect dark = {x - 2 * thick, 0, 4 * thick, height},
             light = {x - thick, 0, 2 * thick, height};
    SDL_SetRenderDrawColor(renderer, 0, 0, 0, SDL_ALPHA_OPAQUE);
    SDL_RenderFillRect(renderer, &dark);
    SDL_SetRenderDrawColor(renderer, UINT8_MAX, UINT8_MAX, UINT8_MAX, SDL_ALPHA_OPAQUE);
    SDL_RenderFillRect(renderer, &light);
}
