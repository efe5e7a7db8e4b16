/**
 * @file
 * @brief A drawing: one picture's blocks and passes, shared out among workers.
 */
#ifndef DIOPTRE_RENDER_RENDER_PASS_H
#define DIOPTRE_RENDER_RENDER_PASS_H

#include "base/clock.h"
#include "dioptre/renderer.h"
#include "render/sample_accumulator.h"

/**
 * Pixels of a block, the piece of work of a thread: wide, so that rows of the picture are written
 * in long runs, and of about a thousand rays, so that stopping takes far less than a frame even
 * with the slowest engine. A multiple of the coarsest stride both ways.
 */
enum { TILE_COLUMNS = 64, TILE_ROWS = 16 };

/** Pixels from one ray to the next in the first pass: 1/64 of the rays, there within a few
 *  milliseconds. */
enum { COARSEST_STRIDE = 8 };

/** A pass over the whole picture. */
typedef struct PassRange {
    int stride;       /**< Pixels from one ray to the next. */
    int first_sample; /**< First sample of each pixel. */
    int last_sample;  /**< Last sample of each pixel. */
} PassRange;

/** A picture being drawn. */
typedef struct RenderPass {
    const Engine *engine;            /**< The engine. */
    const Tracer *tracer;            /**< Its tracer. */
    const Encoder *encoder;          /**< From light to 8 bits. */
    const Encoder *adaptive_encoder; /**< From light to the steps in which samples are compared. */
    int width;                       /**< Pixels. */
    int height;                      /**< Pixels. */
    PassRange range;                 /**< The pass that is being drawn. */
    int samples;                     /**< Samples a pixel that are wanted, at most. */
    SampleAccumulator *accumulator;  /**< What is known of every pixel; NULL: not kept. */
    Picture *picture;                /**< Where the encoded colours go; NULL: nowhere. */
    bool has_previous;               /**< Whether the picture holds the pass before. */
    const atomic_bool *stop;   /**< The blocks left are passed over once it is true; may be NULL. */
    atomic_size_t *rays_done;  /**< Counts the rays of pixels that are done. */
    atomic_size_t *rays_total; /**< Rays of pixels that there are to do. */
    _Atomic uint64_t camera;   /**< Rays from the camera. */
    _Atomic uint64_t reflected;         /**< Mirrored rays. */
    _Atomic uint64_t refracted;         /**< Refracted rays. */
    _Atomic uint64_t total_reflections; /**< Total reflections. */
    _Atomic uint64_t shadow;            /**< Shadow rays. */
} RenderPass;

/**
 * Draws a pass.
 * @param pass  The drawing, with its pass set.
 * @return false when it was stopped.
 */
bool render_pass_run(RenderPass *pass, ThreadPool *thread_pool);

/** @return The rays traced so far. */
RayCounts render_pass_ray_counts(const RenderPass *pass);

/** @return Blocks of a picture. */
size_t tile_count(int width, int height);

/**
 * @return The pixels of a block, all of them.
 * @param width   Pixels of the picture.
 * @param height  Pixels of the picture.
 * @param index   Which block, row by row.
 */
PixelGrid tile_at(int width, int height, size_t index);

/**
 * @return The rays of a pass in a block: one for each cell of stride by stride pixels, in its
 *         middle, also where the picture's edge cuts the cell.
 * @param stride  Pixels from one ray to the next, a power of two up to that of the coarsest pass.
 */
PixelGrid tile_subsample(const PixelGrid *tile, int stride);

#endif
