/**
 * @file
 * @brief Two pictures in one window: side by side with a bar between them, or their difference.
 */
#ifndef DIOPTRE_VIEW_WINDOW_SPLIT_VIEW_H
#define DIOPTRE_VIEW_WINDOW_SPLIT_VIEW_H

#include "render/difference_map.h"
#include "view/window/viewport.h"

/** How many pictures are shown, and how. */
typedef enum {
    SPLIT_NONE,       /**< One alone. */
    SPLIT_BAR,        /**< One left of a bar, the other right of it. */
    SPLIT_DIFFERENCE, /**< Their difference. */
    SPLIT_COUNT       /**< How many ways there are. */
} SplitMode;

/** How two pictures share a window. Starts as `{.bar = 0.5}`. */
typedef struct SplitView {
    SplitMode mode;      /**< How. */
    size_t active;       /**< Which of the two the keys change: 0 left, 1 right. */
    double bar_position; /**< Where the bar stands, as a share of the window's width. */
    bool is_dragged;     /**< Whether the mouse drags it. */
    StreamingTexture difference_texture; /**< The difference. */
    uint8_t *pixels;                     /**< Room for both pictures; owned. NULL: none yet. */
    size_t pixel_capacity;               /**< Pixels of each that there is room for. */
    DifferenceMap difference;            /**< What the difference is. */
} SplitView;

/** Gives its memory back, as it is needed no more. */
void split_view_deinit(SplitView *split);

/**
 * @return Column where the bar stands.
 * @param width  Pixels of the window.
 */
int split_view_column(const SplitView *split, int width);

/** Moves the bar. @param fraction To where, of the window's width. */
void split_view_move_bar(SplitView *split, double fraction);

/**
 * Puts what two sights have drawn together as one picture, as the window shows it.
 * @param[out] bgrx  The picture, of the size of both: blue, green, red, an unused byte a pixel.
 * @param pitch  Bytes from a row to the next.
 * @return false without memory, or while one of them has drawn nothing: nothing is written then.
 */
bool split_view_compose(SplitView *split, const Viewport *left, const Viewport *right,
                        uint8_t *bgrx, int pitch);

/** Brings the difference of two sights to its canvas, if both are there. @param renderer What draws
 *  in the window. */
void split_view_update_difference(SplitView *split, const Viewport *left, const Viewport *right,
                                  SDL_Renderer *renderer);

/** Draws the bar. @param renderer What draws in the window. */
void split_view_draw_bar(const SplitView *split, SDL_Renderer *renderer);

#endif
