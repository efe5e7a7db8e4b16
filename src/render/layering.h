/**
 * @file
 * @brief The inside of drawing layers: a pass, and what its parts share.
 */
#ifndef DIOPTRE_RENDER_LAYERING_H
#define DIOPTRE_RENDER_LAYERING_H

#include "render/renderer.h"

/** A pass of a layer. */
typedef struct LayerPass {
    const Renderer *renderer; /**< Whose. */
    const Layering *layering; /**< What it needs. */
    Picture *picture;         /**< Where the colours go. */
    int width;                /**< Pixels. */
    int height;               /**< Pixels. */
    int stride;               /**< Pixels from one ray to the next. */
    int repeat;               /**< How often it was drawn like this before; -1: coarsely first. */
    bool compares;            /**< Whether the reference is asked. */
    LayerScale scale;         /**< Its colours. */
    _Atomic uint64_t rays;    /**< Rays traced. */
    _Atomic uint64_t pixels;  /**< Pixels that were looked at. */
    _Atomic uint64_t faults;  /**< See #LayerReport.faults. */
    _Atomic uint64_t leaks;   /**< See #LayerReport.leaks. */
} LayerPass;

/** @return Cells of a pass from one row to the next. @param pass The pass. */
static inline size_t cells_across(const LayerPass *pass) {
    return ((size_t)pass->width + (size_t)pass->stride - 1) / (size_t)pass->stride;
}

/** @return Place of a ray's cell among those of the pass. @param pass The pass. @param grid Rays.
 *  @param column Its column in the grid. @param row Its row. */
static inline size_t cell_of(const LayerPass *pass, const PixelGrid *grid, int column, int row) {
    size_t x = (size_t)(grid->x / pass->stride + column);
    size_t y = (size_t)(grid->y / pass->stride + row);
    return y * cells_across(pass) + x;
}

/** @return Whether a drawing was stopped. @param pass The pass. */
static inline bool is_stopped(const LayerPass *pass) {
    return atomic_load_explicit(&pass->renderer->background.stop, memory_order_relaxed);
}

/** Measures the pixels of a block. See #WorkersJob. @param context The pass. @param index Which
 *  block. */
void measure_block(void *context, size_t index);

/** Takes the time of the pixels of a block; in the first pass, of a few in its middle. See
 *  #WorkersJob. @param context The pass. @param index Which block. */
void measure_time(void *context, size_t index);

#endif
