/**
 * @file
 * @brief The inside of drawing layers: a pass, and what its parts share.
 */
#ifndef DIOPTRE_RENDER_LAYER_RENDERER_H
#define DIOPTRE_RENDER_LAYER_RENDERER_H

#include "render/renderer_internal.h"

/** A pass of a layer. */
typedef struct LayerPass {
    const Renderer *renderer;            /**< Whose. */
    const LayerRenderer *layer_renderer; /**< What it needs. */
    Picture *picture;                    /**< Where the colours go. */
    int width;                           /**< Pixels. */
    int height;                          /**< Pixels. */
    int stride;                          /**< Pixels from one ray to the next. */
    int repeat;                 /**< How often it was drawn like this before; -1: coarsely first. */
    bool uses_reference;        /**< Whether the reference is asked. */
    LayerScale scale;           /**< Its colours. */
    _Atomic uint64_t ray_count; /**< Rays traced. */
    _Atomic uint64_t pixel_count;     /**< Pixels that were looked at. */
    _Atomic uint64_t artifact_pixels; /**< See #LayerStats.artifact_pixels. */
    _Atomic uint64_t leak_pixels;     /**< See #LayerStats.leak_pixels. */
} LayerPass;

/** @return Cells of a pass from one row to the next. */
static inline size_t layer_pass_columns(const LayerPass *pass) {
    return ((size_t)pass->width + (size_t)pass->stride - 1) / (size_t)pass->stride;
}

/**
 * @return Place of a ray's cell among those of the pass.
 * @param column  Its column in the grid.
 */
static inline size_t layer_pass_cell_index(const LayerPass *pass, const PixelGrid *grid, int column,
                                           int row) {
    size_t x = (size_t)(grid->x / pass->stride + column);
    size_t y = (size_t)(grid->y / pass->stride + row);
    return y * layer_pass_columns(pass) + x;
}

/** @return Whether a drawing was stopped. */
static inline bool layer_pass_is_stopped(const LayerPass *pass) {
    return atomic_load_explicit(&pass->renderer->background.stop, memory_order_relaxed);
}

/** Measures the pixels of a block. See #ThreadPoolTask. */
void layer_measure_tile(void *context, size_t index);

/** Takes the time of the pixels of a block; in the first pass, of a few in its middle. See
 *  #ThreadPoolTask. */
void layer_time_tile(void *context, size_t index);

#endif
