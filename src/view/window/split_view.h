/**
 * @file
 * @brief Two pictures in one window: side by side with a bar between them, or their difference.
 */
#ifndef DIOPTRE_VIEW_WINDOW_SPLIT_VIEW_H
#define DIOPTRE_VIEW_WINDOW_SPLIT_VIEW_H

#include "render/difference_map.h"
#include "view/state/picture_choice.h"
#include "view/window/viewport.h"

/** The state of two pictures in a window. Starts as `{.bar_position = 0.5}`. */
typedef struct SplitView {
    SplitMode mode;      /**< The mode. */
    size_t active;       /**< The active picture, which keys change: 0 left, 1 right. */
    double bar_position; /**< Position of the bar, fraction of the picture's width. */
    bool is_dragged;     /**< Whether the mouse drags the bar. */
    StreamingTexture difference_texture; /**< Texture of the difference. */
    uint8_t *pixels;                     /**< Pixels of both pictures; owned; NULL: none yet. */
    int width;                           /**< Pixels of each picture in #pixels. */
    int height;                          /**< Pixels of each picture in #pixels. */
    size_t pixel_capacity;               /**< Capacity of #pixels, pixels of each picture. */
    float *values;         /**< Numbers of both layers in the difference; owned; NULL: none yet. */
    size_t value_capacity; /**< Capacity of #values, pixels of each picture. */
    DifferenceMap difference; /**< Statistics of the difference. */
} SplitView;

/** Frees its memory. */
void split_view_deinit(SplitView *split);

/** @return Column of the bar. @param width Pixels of the picture. */
int split_view_column(const SplitView *split, int width);

/** Moves the bar, within margins. @param fraction Fraction of the picture's width. */
void split_view_move_bar(SplitView *split, double fraction);

/**
 * Composes two pictures into one, as the window shows it.
 * @param[out] bgrx  Blue, green, red and an unused byte per pixel, of the size of both.
 * @param pitch  Bytes from a row to the next.
 * @return false without memory, or while one has no pass: nothing is written then.
 */
bool split_view_compose(SplitView *split, const Viewport *left, const Viewport *right,
                        uint8_t *bgrx, int pitch);

/** Updates the texture of the difference, if both pictures have a pass. */
void split_view_update_difference(SplitView *split, const Viewport *left, const Viewport *right,
                                  SDL_Renderer *renderer);

/** Copies the colours of a part of the difference that was composed last. See
 *  #renderer_copy_part. */
void split_view_copy_part(const SplitView *split, int x, int y, int columns, int rows,
                          uint8_t *rgb);

/** Draws the bar. @param picture The picture's rectangle, pixels of the window. */
void split_view_draw_bar(const SplitView *split, SDL_Renderer *renderer, const SDL_Rect *picture);

#endif
