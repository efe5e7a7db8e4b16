/**
 * @file
 * @brief A drawing: one picture's blocks and passes, shared out among workers.
 */
#ifndef DIOPTRE_RENDER_DRAWING_H
#define DIOPTRE_RENDER_DRAWING_H

#include "dioptre/clock.h"
#include "dioptre/renderer.h"
#include "render/tally.h"

/**
 * Pixels of a block, the piece of work of a thread: wide, so that rows of the picture are written
 * in long runs, and of about a thousand rays, so that stopping takes far less than a frame even
 * with the slowest engine. A multiple of the coarsest stride both ways.
 */
enum { BLOCK_COLUMNS = 64, BLOCK_ROWS = 16 };

/** Pixels from one ray to the next in the first pass: 1/64 of the rays, there within a few
 *  milliseconds. */
enum { COARSEST_STRIDE = 8 };

/** A pass over the whole picture. */
typedef struct Pass {
    int stride; /**< Pixels from one ray to the next. */
    int first;  /**< First sample of each pixel. */
    int last;   /**< Last sample of each pixel. */
} Pass;

/** A picture being drawn. */
typedef struct Drawing {
    const Engine *engine;     /**< The engine. */
    const Tracer *tracer;     /**< Its tracer. */
    const Encoder *encoder;   /**< From light to 8 bits. */
    const Encoder *judge;     /**< From light to the steps in which samples are compared. */
    int width;                /**< Pixels. */
    int height;               /**< Pixels. */
    Pass pass;                /**< The pass that is being drawn. */
    int samples;              /**< Samples a pixel that are wanted, at most. */
    Tally *tally;             /**< What is known of every pixel; NULL: not kept. */
    Picture *picture;         /**< Where the encoded colours go; NULL: nowhere. */
    bool is_shown;            /**< Whether the picture holds the pass before. */
    const atomic_bool *stop;  /**< The blocks left are passed over once it is true; may be NULL. */
    atomic_size_t *done;      /**< Counts the rays of pixels that are done. */
    atomic_size_t *all;       /**< Rays of pixels that there are to do. */
    _Atomic uint64_t camera;  /**< Rays from the camera. */
    _Atomic uint64_t mirror;  /**< Mirrored rays. */
    _Atomic uint64_t refract; /**< Refracted rays. */
    _Atomic uint64_t total;   /**< Total reflections. */
    _Atomic uint64_t shadow;  /**< Shadow rays. */
} Drawing;

/**
 * Draws a pass.
 * @param drawing  The drawing, with its pass set.
 * @param workers  Who does it.
 * @return false when it was stopped.
 */
bool drawing_pass(Drawing *drawing, Workers *workers);

/** @return The rays traced so far. @param drawing The drawing. */
RayCounts drawing_rays(const Drawing *drawing);

/** @return Blocks of a picture. @param width Pixels. @param height Pixels. */
size_t drawing_blocks(int width, int height);

/**
 * @return The pixels of a block, all of them.
 * @param width   Pixels of the picture.
 * @param height  Pixels of the picture.
 * @param index   Which block, row by row.
 */
PixelGrid drawing_block(int width, int height, size_t index);

/**
 * @return The rays of a pass in a block: one for each cell of stride by stride pixels, in its
 *         middle, also where the picture's edge cuts the cell.
 * @param block   The block's pixels.
 * @param stride  Pixels from one ray to the next, a power of two up to that of the coarsest pass.
 */
PixelGrid drawing_grid(const PixelGrid *block, int stride);

#endif
