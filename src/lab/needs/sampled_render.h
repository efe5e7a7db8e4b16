/**
 * @file
 * @brief Renders some pixels of a scene, and keeps the colour and the path of every ray.
 */
#ifndef DIOPTRE_LAB_NEEDS_SAMPLED_RENDER_H
#define DIOPTRE_LAB_NEEDS_SAMPLED_RENDER_H

#include "dioptre/engine.h"

#include <stdatomic.h>

/* --- which pixels ------------------------------------------------------------------------------
 */

/** Some pixels of a picture, in the order of its tiles. */
typedef struct PixelSet {
    int width;          /**< Of the whole picture. */
    int height;         /**< Of the whole picture. */
    size_t tile_count;  /**< Tiles of the whole picture. */
    size_t *tile_first; /**< Per tile, and once more at the end: pixels before it; owned. */
    uint16_t *chosen;   /**< See #PixelGrid.selected, tile after tile; owned. */
    size_t count;       /**< Pixels in the set. */
} PixelSet;

/** @return Whether a pixel is in a set. */
typedef bool (*PixelTest)(const void *context, int x, int y);

/**
 * Makes a set.
 * @param[out] pixels  The set, to be released with #pixel_set_deinit.
 * @param test         Which pixels are in it.
 * @param context      Passed to the test.
 * @return false without memory.
 */
bool pixel_set_init(PixelSet *pixels, int width, int height, PixelTest test, const void *context,
                    Error *error);

/** Is a #PixelTest: all pixels. */
bool pixel_is_any(const void *context, int x, int y);

/** Most pixels along a side of a cell of which one pixel is sampled. */
enum { SAMPLING_CELL_MAXIMUM = 8 };

/** @return Pixels along a side of such a cell, a power of two: fewer in small pictures. */
int sampling_cell_of(int width, int height);

/** Is a #PixelTest: one pixel of each cell, at a pseudo-random position that is always the same.
 * The context is an `int`, the pixels along a side of a cell. */
bool pixel_is_sampled(const void *context, int x, int y);

/** Releases a set, which may be empty. */
void pixel_set_deinit(PixelSet *pixels);

/** @return The pixels of a set in a tile; an empty grid must not be traced. */
PixelGrid pixel_set_tile_grid(const PixelSet *pixels, size_t tile);

/* --- rendered how ------------------------------------------------------------------------------
 */

/** How pixels are traced. */
typedef struct Variant {
    const Engine *engine; /**< The engine. */
    TraceSettings trace;  /**< Its settings; the samples are those of the whole picture. */
    int samples_traced;   /**< How many of the samples of each pixel are traced. */
} Variant;

/** What is rendered. */
typedef struct RenderContext {
    const Scene *scene;      /**< The scene. */
    const PixelSet *pixels;  /**< The pixels. */
    int threads;             /**< How many threads trace. */
    const atomic_bool *stop; /**< Rendering stops once it is true; may be NULL. */
} RenderContext;

/** The rays of rendered pixels. */
typedef struct SampledRender {
    size_t ray_count;      /**< Camera rays: pixels times samples. */
    double *rgb;           /**< Linear light per ray, three numbers; sample after sample; owned. */
    uint64_t *path_hashes; /**< Path hash per ray; owned. */
    double cpu_seconds;    /**< CPU time of all threads. */
    RayCounts ray_counts;  /**< All rays traced. */
} SampledRender;

/**
 * Renders.
 * @param[out] render  The rays, to be released with #sampled_render_deinit.
 * @param[out] error   What is wrong; #STATUS_INTERRUPTED where it was stopped.
 * @return false if anything is wrong.
 */
bool render_samples(const RenderContext *render_context, const Variant *variant,
                    SampledRender *render, Error *error);

/** Releases rays; there may be none. */
void sampled_render_deinit(SampledRender *render);

#endif
