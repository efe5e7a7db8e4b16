/**
 * @file
 * @brief Passes over a picture, coarse to fine, tile by tile, on several threads.
 *
 * Every picture, the shaded one as well as a layer, comes from the same pipeline: a sequence of
 * passes (#pass_range_next), each of which shades all tiles (#render_pass_run_tiles) and reports
 * (#render_pass_stats). What the kinds differ in is the function that shades a tile.
 */
#ifndef DIOPTRE_RENDER_RENDER_PASS_H
#define DIOPTRE_RENDER_RENDER_PASS_H

#include "base/clock.h"
#include "dioptre/renderer.h"
#include "render/sample_accumulator.h"

/**
 * Pixels of a tile, the unit of work of a thread. Tiles are wide, so that rows of the picture are
 * written in long runs. They are low: glass makes some a hundred times as slow as others, and no
 * thread shall wait long for the last tile (tests/schedule.sh). Five hundred rays take far less
 * time than a frame even with the slowest engine, so a pass stops soon. A multiple of the coarsest
 * stride both ways.
 */
enum { TILE_COLUMNS = 64, TILE_ROWS = 8 };

/** Pixels from one ray to the next in the first pass: it takes 1/64 of the rays and a few
 *  milliseconds. */
enum { COARSEST_STRIDE = 8 };

/** Seconds that all processors are left to the window after a preview: two frames of a 60 Hz
 *  screen. The slow passes that follow would hold up the preview on its way to the screen. */
#define PREVIEW_PAUSE (2.0 / 60)

/** A pass over the whole picture. */
typedef struct PassRange {
    int stride;       /**< Pixels from one ray to the next; 0: before the first pass. */
    int first_sample; /**< First sample of each pixel. */
    int last_sample;  /**< Last sample of each pixel. */
    bool is_preview;  /**< Whether it only bridges the time until the first coarse pass. */
} PassRange;

typedef struct RenderPass RenderPass;

/** A pass under way, and the pipeline that it belongs to. */
struct RenderPass {
    Renderer *renderer;              /**< Its renderer. */
    const Engine *engine;            /**< The engine. */
    const Tracer *tracer;            /**< Its tracer. */
    const Encoder *encoder;          /**< From linear light to 8 bits. */
    const Encoder *adaptive_encoder; /**< From linear light to the steps that samples differ by. */
    int width;                       /**< Pixels. */
    int height;                      /**< Pixels. */
    PassRange range;                 /**< The rays of this pass. */
    int samples;                     /**< Samples per pixel, at most. */
    SampleAccumulator *accumulator;  /**< Sums over passes; NULL: a single pass. */
    Picture *picture;                /**< The output; NULL: none. */
    bool has_previous;               /**< Whether the picture holds the previous pass. */
    const atomic_bool *stop;         /**< Once true, the tiles left are skipped; may be NULL. */
    double start;                    /**< Begin of the first pass, on #clock_now_seconds. */
    double full_resolution_seconds;  /**< Seconds until every pixel had a ray; 0: not yet. */

    /** Called after each tile that is in the picture, on several threads at once; tiles are then
     *  shaded from the middle outwards. NULL: none. @param index The tile's number. */
    void (*on_tile)(RenderPass *pass, size_t index);

    _Atomic uint64_t camera;            /**< Camera rays. */
    _Atomic uint64_t reflected;         /**< Reflected rays. */
    _Atomic uint64_t refracted;         /**< Refracted rays. */
    _Atomic uint64_t total_reflections; /**< Total reflections. */
    _Atomic uint64_t unresolved;        /**< #RayCounts.unresolved */
    _Atomic double unresolved_steps;    /**< #RayCounts.unresolved_steps */
    _Atomic uint64_t shadow;            /**< Shadow rays. */

    Layer layer;                      /**< The layer; the shaded picture is one of them. */
    LayerScale scale;                 /**< The scale of a layer's colours. */
    _Atomic uint64_t pixel_count;     /**< Rays of a layer that have a colour in this pass. */
    _Atomic uint64_t artifact_pixels; /**< See #LayerStats.artifact_pixels. */
    _Atomic uint64_t leak_pixels;     /**< See #LayerStats.leak_pixels. */
};

/**
 * Finds the next pass: strides 8, 4, 2 and 1, then one more sample per pixel each.
 * @param[in,out] range  The finished pass; `{0}` before the first.
 * @param samples      Samples per pixel.
 * @param has_preview  Whether a preview, of the coarsest stride, comes first.
 * @return false after the last pass.
 */
bool pass_range_next(PassRange *range, int samples, bool has_preview);

/** @return Rays from pixels in all passes. See #pass_range_next. */
size_t pass_range_total_rays(int width, int height, int samples, bool has_preview);

/** @return Whether the pass is to stop, as far as is known: for engines, in the middle of a tile,
 *          where no other part of the program may run. */
static inline bool render_pass_has_stop(const RenderPass *pass) {
    return pass->stop && atomic_load_explicit(pass->stop, memory_order_relaxed);
}

/** @return Whether the pass is to stop. To be asked often: where a program has one thread, others
 * have their turn meanwhile. */
bool render_pass_is_stopped(const RenderPass *pass);

/**
 * Shades a tile of a pass. Called on several threads at once.
 * @param tile   Its pixels, all of them.
 * @param index  Its number, row by row.
 */
typedef void (*ShadeTile)(RenderPass *pass, const PixelGrid *tile, size_t index);

/** Shades all tiles of a pass. @return false when it was stopped. */
bool render_pass_run_tiles(RenderPass *pass, ShadeTile shade);

/** Adds the rays of a tile to those of the pass, and its pixels' to the progress. @param rays Rays
 *  from pixels. */
void render_pass_add_rays(RenderPass *pass, const RayCounts *counts, size_t rays);

/** @return The state of the picture after a pass. @param is_last Whether it was the last one. */
RenderStats render_pass_stats(RenderPass *pass, bool is_last);

/** Renders a pass of the shaded picture. @return false when it was stopped. */
bool render_pass_run_samples(RenderPass *pass);

/** Renders a pass of the renderer's layer. @return false when it was stopped. */
bool render_pass_run_layer(RenderPass *pass);

/** @return Number of tiles of a picture. */
size_t tile_count(int width, int height);

/**
 * @return The pixels of a tile, all of them.
 * @param width   Pixels of the picture.
 * @param height  Pixels of the picture.
 * @param index   Its number, row by row.
 */
PixelGrid tile_at(int width, int height, size_t index);

/**
 * @return The rays of a pass in a tile: one per cell of stride by stride pixels, at its centre,
 * also where the picture's edge cuts the cell.
 * @param stride  Pixels from one ray to the next, a power of two up to #COARSEST_STRIDE.
 */
PixelGrid tile_subsample(const PixelGrid *tile, int stride);

#endif
