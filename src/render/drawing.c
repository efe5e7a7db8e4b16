/**
 * @file
 * @brief Blocks and passes.
 */
#include "render/drawing.h"

#include <string.h>
#include <time.h>

/** Numbers a block: three primaries a pixel. */
#define BLOCK_NUMBERS (BLOCK_COLUMNS * BLOCK_ROWS * 3)

double clock_seconds(void) {
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/** @return Blocks in a row. @param width Pixels of the picture. */
static size_t blocks_across(int width) {
    return ((size_t)width + BLOCK_COLUMNS - 1) / BLOCK_COLUMNS;
}

size_t drawing_blocks(int width, int height) {
    return blocks_across(width) * (((size_t)height + BLOCK_ROWS - 1) / BLOCK_ROWS);
}

PixelGrid drawing_block(int width, int height, size_t index) {
    int x = (int)(index % blocks_across(width)) * BLOCK_COLUMNS;
    int y = (int)(index / blocks_across(width)) * BLOCK_ROWS;
    int columns = width - x < BLOCK_COLUMNS ? width - x : BLOCK_COLUMNS;
    int rows = height - y < BLOCK_ROWS ? height - y : BLOCK_ROWS;
    return (PixelGrid){.x = x, .y = y, .columns = columns, .rows = rows, .stride = 1};
}

/**
 * @return The rays of a pass in a block: one for each cell of stride by stride pixels, in its
 *         middle, also where the picture's edge cuts the cell.
 * @param block   The block's pixels.
 * @param stride  Pixels from one ray to the next.
 */
static PixelGrid block_grid(const PixelGrid *block, int stride) {
    PixelGrid grid = *block;
    grid.x += stride / 2;
    grid.y += stride / 2;
    grid.columns = (block->columns + stride - 1) / stride;
    grid.rows = (block->rows + stride - 1) / stride;
    grid.stride = stride;
    return grid;
}

/**
 * Copies the sums of a block from or to the whole picture's, plane by plane.
 * @param drawing  The drawing.
 * @param block    The block's pixels.
 * @param numbers  The block's sums.
 * @param is_load  true: from the picture; false: to it.
 */
static void block_sums(Drawing *drawing, const PixelGrid *block, double *numbers, bool is_load) {
    size_t pixels = (size_t)drawing->width * (size_t)drawing->height;
    size_t columns = (size_t)block->columns;
    for (size_t row = 0; row < 3 * (size_t)block->rows; row++, numbers += columns) {
        size_t plane = row / (size_t)block->rows, y = row % (size_t)block->rows + (size_t)block->y;
        double *whole =
            drawing->sums + plane * pixels + y * (size_t)drawing->width + (size_t)block->x;
        memcpy(is_load ? numbers : whole, is_load ? whole : numbers, columns * sizeof *numbers);
    }
}

/**
 * Encodes a row of rays.
 * @param drawing  The drawing.
 * @param sums     Sums of the samples: the reds of the row.
 * @param plane    How much farther the greens are, and then the blues.
 * @param columns  How many rays.
 * @param[out] rgb Their encoded colours.
 */
static void row_encode(const Drawing *drawing, const double *sums, size_t plane, int columns,
                       uint8_t *rgb) {
    double share = 1.0 / (drawing->pass.last + 1);
    for (int i = 0; i < columns; i++) {
        for (size_t primary = 0; primary < 3; primary++) {
            float light = (float)(sums[primary * plane + (size_t)i] * share);
            rgb[3 * (size_t)i + primary] = encoder_encode(drawing->encoder, light);
        }
    }
}

/**
 * Writes a block into the picture: each ray's colour fills its cell.
 * @param drawing  The drawing.
 * @param block    The block's pixels.
 * @param grid     The block's rays.
 * @param sums     Sum of the samples of each ray.
 */
static void block_encode(const Drawing *drawing, const PixelGrid *block, const PixelGrid *grid,
                         const double *sums) {
    uint8_t cells[3 * BLOCK_COLUMNS];
    size_t plane = (size_t)grid->columns * (size_t)grid->rows;
    for (int row = 0; row < block->rows; row++) {
        size_t first = (size_t)(block->y + row) * (size_t)drawing->width + (size_t)block->x;
        uint8_t *pixels = drawing->picture->pixels + 3 * first;
        const double *row_sums = sums + (size_t)(row / grid->stride) * (size_t)grid->columns;
        if (grid->stride == 1) {
            row_encode(drawing, row_sums, plane, grid->columns, pixels);
            continue;
        }
        row_encode(drawing, row_sums, plane, grid->columns, cells);
        for (int column = 0; column < block->columns; column++) {
            memcpy(pixels + 3 * column, cells + 3 * (column / grid->stride), 3);
        }
    }
}

/** Adds up samples. @param[in,out] sums The sums. @param sample One sample. @param rays How many.
 */
static void block_add(double *sums, const double *sample, size_t rays) {
    for (size_t i = 0; i < 3 * rays; i++) {
        sums[i] += sample[i];
    }
}

/**
 * Traces the samples of a pass in a block.
 * @param drawing  The drawing.
 * @param grid     The block's rays.
 * @param[in,out] sums  Sums of the samples before the pass; with those of the pass afterwards.
 * @param[in,out] counts  The rays traced.
 * @return false when it was stopped.
 */
static bool block_trace(const Drawing *drawing, PixelGrid *grid, double *sums, RayCounts *counts) {
    double colors[BLOCK_NUMBERS];
    size_t rays = (size_t)grid->columns * (size_t)grid->rows;
    for (int sample = drawing->pass.first; sample <= drawing->pass.last; sample++) {
        if (drawing->stop && atomic_load_explicit(drawing->stop, memory_order_relaxed)) {
            return false;
        }
        grid->sample = sample;
        drawing->engine->trace(drawing->tracer, grid, sample == 0 ? sums : colors, counts);
        if (sample > 0) {
            block_add(sums, colors, rays);
        }
        atomic_fetch_add_explicit(drawing->done, rays, memory_order_relaxed);
    }
    return true;
}

/** Draws a block. See #WorkersJob. @param context The drawing. @param index Which block. */
static void block_draw(void *context, size_t index) {
    Drawing *drawing = context;
    double sums[BLOCK_NUMBERS];
    RayCounts counts = {0};
    PixelGrid block = drawing_block(drawing->width, drawing->height, index);
    PixelGrid grid = block_grid(&block, drawing->pass.stride);
    if (drawing->pass.first > 0) {
        block_sums(drawing, &block, sums, true);
    }
    bool is_whole = block_trace(drawing, &grid, sums, &counts);
    if (is_whole && drawing->sums && drawing->pass.stride == 1) {
        block_sums(drawing, &block, sums, false);
    }
    if (is_whole && drawing->picture) {
        block_encode(drawing, &block, &grid, sums);
    }
    atomic_fetch_add_explicit(&drawing->camera, counts.camera, memory_order_relaxed);
    atomic_fetch_add_explicit(&drawing->mirror, counts.mirror, memory_order_relaxed);
    atomic_fetch_add_explicit(&drawing->refract, counts.refract, memory_order_relaxed);
    atomic_fetch_add_explicit(&drawing->total, counts.total, memory_order_relaxed);
    atomic_fetch_add_explicit(&drawing->shadow, counts.shadow, memory_order_relaxed);
}

bool drawing_pass(Drawing *drawing, Workers *workers) {
    workers_run(workers, drawing_blocks(drawing->width, drawing->height), block_draw, drawing);
    return !(drawing->stop && atomic_load(drawing->stop));
}

RayCounts drawing_rays(const Drawing *drawing) {
    return (RayCounts){.camera = atomic_load(&drawing->camera),
                       .mirror = atomic_load(&drawing->mirror),
                       .refract = atomic_load(&drawing->refract),
                       .total = atomic_load(&drawing->total),
                       .shadow = atomic_load(&drawing->shadow)};
}
