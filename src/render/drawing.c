/**
 * @file
 * @brief Blocks and passes.
 */
#include "render/drawing.h"

#include <string.h>

/** Pixels a block. */
#define BLOCK_PIXELS (BLOCK_COLUMNS * BLOCK_ROWS)

/** Numbers a block: three primaries a pixel. */
#define BLOCK_NUMBERS (BLOCK_PIXELS * 3)

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

PixelGrid drawing_grid(const PixelGrid *block, int stride) {
    PixelGrid grid = *block;
    grid.x += stride / 2;
    grid.y += stride / 2;
    grid.columns = (block->columns + stride - 1) / stride;
    grid.rows = (block->rows + stride - 1) / stride;
    grid.stride = stride;
    return grid;
}

/** A block of a pass, as the worker that draws it sees it. */
typedef struct BlockWork {
    PixelGrid block;               /**< Its pixels. */
    PixelGrid grid;                /**< Its rays. */
    double sums[BLOCK_NUMBERS];    /**< Sum of the samples, plane by plane. */
    double lows[BLOCK_NUMBERS];    /**< Least of this pass's samples; where the tally judges. */
    double highs[BLOCK_NUMBERS];   /**< Greatest of them. */
    uint32_t counts[BLOCK_PIXELS]; /**< Samples a pixel. */
    RayCounts rays;                /**< The rays traced. */
} BlockWork;

/**
 * Copies the sums of a block from or to the whole picture's, plane by plane.
 * @param tally    The whole picture's.
 * @param work     The block.
 * @param is_load  true: from the picture; false: to it.
 */
static void block_sums(Tally *tally, BlockWork *work, bool is_load) {
    const PixelGrid *block = &work->block;
    size_t pixels = (size_t)tally->width * (size_t)tally->height;
    size_t columns = (size_t)block->columns;
    double *numbers = work->sums;
    for (size_t row = 0; row < 3 * (size_t)block->rows; row++, numbers += columns) {
        size_t plane = row / (size_t)block->rows, y = row % (size_t)block->rows + (size_t)block->y;
        double *whole = tally->sums + plane * pixels + y * (size_t)tally->width + (size_t)block->x;
        memcpy(is_load ? numbers : whole, is_load ? whole : numbers, columns * sizeof *numbers);
    }
}

/** @return Place of the first pixel of a block's row in the whole picture. @param drawing The
 *  drawing. @param block The block. @param row Which row of it. */
static size_t row_place(const Drawing *drawing, const PixelGrid *block, int row) {
    return (size_t)(block->y + row) * (size_t)drawing->width + (size_t)block->x;
}

/** @return Whether the drawing's pixels are judged. @param drawing The drawing. */
static bool is_judging(const Drawing *drawing) {
    return drawing->tally && drawing->tally->counts;
}

/** Takes what is known of a block before a pass. @param drawing The drawing.
 *  @param[in,out] work The block. */
static void block_load(const Drawing *drawing, BlockWork *work) {
    const PixelGrid *block = &work->block;
    size_t columns = (size_t)block->columns;
    if (drawing->pass.first > 0) {
        block_sums(drawing->tally, work, true);
    }
    for (int row = 0; drawing->pass.first > 0 && is_judging(drawing) && row < block->rows; row++) {
        memcpy(work->counts + (size_t)row * columns,
               drawing->tally->counts + row_place(drawing, block, row),
               columns * sizeof *work->counts);
    }
}

/** Notes the range of one primary of a pixel. @param drawing The drawing. @param number Its place
 * in the tally. @param low Least of a pass's samples. @param high Greatest. @param is_first Whether
 *  nothing was known of it. */
static void range_note(const Drawing *drawing, size_t number, double low, double high,
                       bool is_first) {
    uint16_t *known_low = &drawing->tally->lows[number],
             *known_high = &drawing->tally->highs[number];
    bool beyond = drawing->picture && drawing->picture->light;
    uint16_t least = tally_step(drawing->judge, (float)low, beyond);
    uint16_t greatest = low < high ? tally_step(drawing->judge, (float)high, beyond) : least;
    *known_low = is_first || least < *known_low ? least : *known_low;
    *known_high = is_first || greatest > *known_high ? greatest : *known_high;
}

/** Keeps the samples of a row of a block in the tally. @param drawing The drawing.
 *  @param work The block. @param row Which row. */
static void row_save(const Drawing *drawing, const BlockWork *work, int row) {
    Tally *tally = drawing->tally;
    size_t columns = (size_t)work->block.columns, plane = columns * (size_t)work->block.rows;
    size_t place = row_place(drawing, &work->block, row), at = (size_t)row * columns;
    bool is_first = drawing->pass.first == 0;
    for (size_t end = at + columns; at < end; at++, place++) {
        if (!is_first && tally->counts[place] == work->counts[at]) {
            continue;
        }
        tally->counts[place] = work->counts[at];
        for (size_t primary = 0; primary < 3; primary++) {
            size_t number = primary * plane + at;
            range_note(drawing, 3 * place + primary, work->lows[number], work->highs[number],
                       is_first);
        }
    }
}

/** Keeps what is known of a block after a pass over pixels. @param drawing The drawing.
 *  @param work The block. */
static void block_save(const Drawing *drawing, BlockWork *work) {
    block_sums(drawing->tally, work, false);
    for (int row = 0; is_judging(drawing) && row < work->block.rows; row++) {
        row_save(drawing, work, row);
    }
}

/**
 * Keeps the light of a row of rays.
 * @param sums     Sums of the samples: the reds of the row.
 * @param plane    How much farther the greens are, and then the blues.
 * @param counts   How many samples.
 * @param columns  How many rays.
 * @param[out] rgb Their light.
 */
static void row_keep(const double *sums, size_t plane, const uint32_t *counts, int columns,
                     float *rgb) {
    for (size_t i = 0; i < 3 * (size_t)columns; i++) {
        rgb[i] = (float)(sums[i % 3 * plane + i / 3] * (1.0 / counts[i / 3]));
    }
}

/**
 * Encodes a row of rays.
 * @param drawing  The drawing.
 * @param sums     Sums of the samples: the reds of the row.
 * @param plane    How much farther the greens are, and then the blues.
 * @param counts   How many samples.
 * @param columns  How many rays.
 * @param[out] rgb Their encoded colours.
 */
static void row_encode(const Drawing *drawing, const double *sums, size_t plane,
                       const uint32_t *counts, int columns, uint8_t *rgb) {
    for (int i = 0; i < columns; i++) {
        double share = 1.0 / counts[i];
        for (size_t primary = 0; primary < 3; primary++) {
            float light = (float)(sums[primary * plane + (size_t)i] * share);
            rgb[3 * (size_t)i + primary] = encoder_encode(drawing->encoder, light);
        }
    }
}

/**
 * Writes a block into the picture: each ray's colour fills its cell.
 * @param drawing  The drawing.
 * @param work     The block.
 */
static void block_encode(const Drawing *drawing, const BlockWork *work) {
    uint8_t cells[3 * BLOCK_COLUMNS];
    const PixelGrid *block = &work->block, *grid = &work->grid;
    size_t plane = (size_t)grid->columns * (size_t)grid->rows;
    for (int row = 0; row < block->rows; row++) {
        size_t place = row_place(drawing, block, row);
        uint8_t *pixels = drawing->picture->pixels + 3 * place;
        size_t at = (size_t)(row / grid->stride) * (size_t)grid->columns;
        const double *sums = work->sums + at;
        const uint32_t *counts = work->counts + at;
        bool is_whole = grid->stride == 1;
        if (is_whole && drawing->picture->light) {
            row_keep(sums, plane, counts, grid->columns, drawing->picture->light + 3 * place);
        }
        row_encode(drawing, sums, plane, counts, grid->columns, is_whole ? pixels : cells);
        for (int column = 0; !is_whole && column < block->columns; column++) {
            memcpy(pixels + 3 * column, cells + 3 * (column / grid->stride), 3);
        }
    }
}

/** @return The smaller. @param a A number. @param b Another. */
static inline double smaller(double a, double b) {
    return a < b ? a : b;
}

/** @return The larger. @param a A number. @param b Another. */
static inline double larger(double a, double b) {
    return a > b ? a : b;
}

/** Adds a sample of all rays to the sums, unless it is the first of all and stands there already,
 * and to the ranges where the tally judges.
 *  @param[in,out] work The block. @param colors The sample. @param is_first Whether it is the first
 *  of the pass. @param judges Whether ranges are wanted. */
static void block_add(BlockWork *work, const double *colors, bool is_first, bool judges) {
    size_t numbers = 3 * (size_t)work->grid.columns * (size_t)work->grid.rows;
    for (size_t i = 0; work->grid.sample > 0 && i < numbers; i++) {
        work->sums[i] += colors[i];
    }
    if (judges && is_first) {
        memcpy(work->lows, colors, numbers * sizeof *colors);
        memcpy(work->highs, colors, numbers * sizeof *colors);
    }
    for (size_t i = 0; judges && !is_first && i < numbers; i++) {
        work->lows[i] = smaller(work->lows[i], colors[i]);
        work->highs[i] = larger(work->highs[i], colors[i]);
    }
}

/** @return Whether the drawing was stopped. @param drawing The drawing. */
static bool is_stopped(const Drawing *drawing) {
    return drawing->stop && atomic_load_explicit(drawing->stop, memory_order_relaxed);
}

/**
 * Traces the samples of a pass, one for each ray of a block.
 * @param drawing  The drawing.
 * @param[in,out] work  The block.
 * @return false when it was stopped.
 */
static bool block_trace(const Drawing *drawing, BlockWork *work) {
    double colors[BLOCK_NUMBERS];
    size_t rays = (size_t)work->grid.columns * (size_t)work->grid.rows;
    bool judges = is_judging(drawing) && drawing->pass.stride == 1;
    for (int sample = drawing->pass.first; sample <= drawing->pass.last; sample++) {
        if (is_stopped(drawing)) {
            return false;
        }
        work->grid.sample = sample;
        double *traced = sample == 0 ? work->sums : colors; // The first is the sum so far.
        drawing->engine->trace(drawing->tracer, &work->grid, traced, &work->rays);
        block_add(work, traced, sample == drawing->pass.first, judges);
        atomic_fetch_add_explicit(drawing->done, rays, memory_order_relaxed);
    }
    for (size_t i = 0; i < rays; i++) {
        work->counts[i] = (uint32_t)drawing->pass.last + 1;
    }
    return true;
}

/** @return The open pixels that lack a sample, in front. @param open The open ones.
 *  @param count How many. @param counts Samples a pixel. @param sample Which sample.
 *  @param[out] chosen Those that lack it. */
static size_t choose_lacking(const uint16_t *open, size_t count, const uint32_t *counts, int sample,
                             uint16_t *chosen) {
    size_t chosen_count = 0;
    for (size_t i = 0; i < count; i++) {
        if (counts[open[i]] == (uint32_t)sample) {
            chosen[chosen_count++] = open[i];
        }
    }
    return chosen_count;
}

/** Adds a sample of chosen pixels. @param[in,out] work The block, with the chosen in its grid.
 *  @param colors The sample. @param is_new Whether a pixel is new to the pass, by place; then not.
 */
static void chosen_add(BlockWork *work, const double *colors, bool *is_new) {
    const PixelGrid *grid = &work->grid;
    size_t plane = (size_t)grid->columns * (size_t)grid->rows;
    for (size_t i = 0; i < grid->chosen_count; i++) {
        size_t pixel = grid->chosen[i];
        for (size_t primary = 0; primary < 3; primary++) {
            size_t at = primary * plane + pixel;
            double color = colors[primary * grid->chosen_count + i];
            work->sums[at] += color;
            work->lows[at] = is_new[pixel] ? color : smaller(work->lows[at], color);
            work->highs[at] = is_new[pixel] ? color : larger(work->highs[at], color);
        }
        is_new[pixel] = false;
        work->counts[pixel]++;
    }
}

/**
 * Traces the samples that the open pixels of a block lack.
 * @param drawing  The drawing.
 * @param[in,out] work  The block.
 * @param open        The open pixels.
 * @param open_count  How many.
 * @return false when it was stopped.
 */
static bool open_trace(const Drawing *drawing, BlockWork *work, const uint16_t *open,
                       size_t open_count) {
    double colors[BLOCK_NUMBERS];
    uint16_t chosen[BLOCK_PIXELS];
    bool is_new[BLOCK_PIXELS];
    memset(is_new, true, sizeof is_new);
    for (int sample = tally_first(drawing->samples); open_count > 0 && sample <= drawing->pass.last;
         sample++) {
        if (is_stopped(drawing)) {
            return false;
        }
        size_t count = choose_lacking(open, open_count, work->counts, sample, chosen);
        if (count > 0) {
            work->grid.sample = sample;
            work->grid.chosen = chosen;
            work->grid.chosen_count = count;
            drawing->engine->trace(drawing->tracer, &work->grid, colors, &work->rays);
            chosen_add(work, colors, is_new);
            atomic_fetch_add_explicit(drawing->done, count, memory_order_relaxed);
        }
    }
    return true;
}

/** Ends a block: keeps its samples, shows them. @param drawing The drawing.
 *  @param[in,out] work The block. */
static void block_end(Drawing *drawing, BlockWork *work) {
    if (drawing->tally && drawing->pass.stride == 1) {
        block_save(drawing, work);
    }
    if (drawing->picture) {
        block_encode(drawing, work);
    }
    atomic_fetch_add_explicit(&drawing->camera, work->rays.camera, memory_order_relaxed);
    atomic_fetch_add_explicit(&drawing->mirror, work->rays.mirror, memory_order_relaxed);
    atomic_fetch_add_explicit(&drawing->refract, work->rays.refract, memory_order_relaxed);
    atomic_fetch_add_explicit(&drawing->total, work->rays.total, memory_order_relaxed);
    atomic_fetch_add_explicit(&drawing->shadow, work->rays.shadow, memory_order_relaxed);
}

/** Draws a block, all its rays alike. See #WorkersJob. @param context The drawing. @param index
 *  Which block. */
static void block_draw(void *context, size_t index) {
    Drawing *drawing = context;
    BlockWork work;
    work.block = drawing_block(drawing->width, drawing->height, index);
    work.grid = drawing_grid(&work.block, drawing->pass.stride);
    work.rays = (RayCounts){0};
    block_load(drawing, &work);
    if (block_trace(drawing, &work)) {
        block_end(drawing, &work);
    }
}

/** Draws the open pixels of a block. See #WorkersJob. @param context The drawing. @param index
 * Which block. */
static void block_draw_open(void *context, size_t index) {
    Drawing *drawing = context;
    BlockWork work;
    uint16_t open[BLOCK_PIXELS];
    work.block = work.grid = drawing_block(drawing->width, drawing->height, index);
    work.rays = (RayCounts){0};
    size_t open_count = tally_open(drawing->tally, &work.block, open);
    if (open_count == 0 && drawing->is_shown) {
        return;
    }
    block_load(drawing, &work);
    if (open_trace(drawing, &work, open, open_count)) {
        block_end(drawing, &work);
    }
}

bool drawing_pass(Drawing *drawing, Workers *workers) {
    bool is_open = is_judging(drawing) && drawing->pass.first >= tally_first(drawing->samples);
    if (is_open && tally_is_due(drawing->pass.first)) {
        size_t left = tally_judge(drawing->tally, workers, drawing->samples);
        atomic_store(drawing->all, atomic_load(drawing->done) + left);
    }
    workers_run(workers, drawing_blocks(drawing->width, drawing->height),
                is_open ? block_draw_open : block_draw, drawing);
    return !(drawing->stop && atomic_load(drawing->stop));
}

RayCounts drawing_rays(const Drawing *drawing) {
    return (RayCounts){.camera = atomic_load(&drawing->camera),
                       .mirror = atomic_load(&drawing->mirror),
                       .refract = atomic_load(&drawing->refract),
                       .total = atomic_load(&drawing->total),
                       .shadow = atomic_load(&drawing->shadow)};
}
