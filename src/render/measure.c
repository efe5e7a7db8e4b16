/**
 * @file
 * @brief The numbers of layers, block by block.
 */
#include "render/layering.h"

#include "dioptre/encoding.h"

/** Rows of rays that are asked for at once by engines of many lanes; after each, a drawing can be
 *  stopped. Those of one lane, which are slow, take one. */
enum { STRIP_ROWS = 8 };
/** Rays of a strip, at most. */
enum { STRIP_RAYS = BLOCK_COLUMNS * STRIP_ROWS };
/** Columns and rows of pixels whose time is taken together by an engine of one lane. */
enum { SINGLE_COLUMNS = 4, SINGLE_ROWS = 2 };

/** @return A pixel's brightness, as it is seen, 0 to 1; faint, so that what is marked stands out.
 *  @param pass The pass. @param color Linear light. */
static float brightness(const LayerPass *pass, const double color[3]) {
    /** Of full light. */
    const float faint = 0.75F;
    // The shares of the primaries of sRGB (ITU-R BT.709).
    double light = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    uint8_t step = encoder_encode(&pass->renderer->encoder, (float)light);
    return (float)step / ENCODING_STEP_MAXIMUM * faint;
}

/** @return The largest difference of a primary, in steps of 8 bits. @param a Linear light.
 *  @param b Other light. */
static float steps_between(const double a[3], const double b[3]) {
    double largest = 0;
    for (int i = 0; i < 3; i++) {
        if (a[i] != b[i]) {
            double x = encoding_encode(ENCODING_SRGB, a[i] > 1 ? 1 : a[i]);
            double y = encoding_encode(ENCODING_SRGB, b[i] > 1 ? 1 : b[i]);
            largest = fmax(largest, fabs(x - y));
        }
    }
    return (float)largest;
}

/** @return What a pixel's rays meet, as one number: the same where they meet the same. @param point
 *          The pixel. */
static uint32_t mark_of(const SurveyPoint *point) {
    /** Multiplier of a linear congruential generator (Knuth, MMIX). */
    const uint64_t multiplier = UINT64_C(6364136223846793005);
    uint64_t mark = (point->dark + 1) * multiplier + point->asked;
    for (uint32_t i = 0; i < point->next_count; i++) {
        mark = mark * multiplier + (uint64_t)(point->next[i] + 2);
    }
    return (uint32_t)((mark * multiplier) >> 32);
}

/** @return What is wrong with a pixel. @param seen What an engine says of it. @param truth What the
 *  reference says. */
static LayerFault fault_of(const SurveyPoint *seen, const SurveyPoint *truth) {
    if (seen->shape != truth->shape || seen->shape < 0) {
        return FAULT_NONE;
    }
    uint64_t both = seen->asked & truth->asked, other = (seen->dark ^ truth->dark) & both;
    if (other) {
        return seen->dark & other ? FAULT_ACNE : FAULT_LEAK;
    }
    for (uint32_t i = 0; i < seen->next_count && i < truth->next_count; i++) {
        if (seen->next[i] != truth->next[i]) {
            return seen->next[i] == seen->shape ? FAULT_ACNE : FAULT_LEAK;
        }
    }
    return FAULT_NONE;
}

/** Takes the numbers of a strip from a survey. @param pass The pass. @param strip The rays.
 *  @return How many were traced. */
static RayCounts strip_survey(const LayerPass *pass, const PixelGrid *strip) {
    const Layering *layering = pass->layering;
    SurveyPoint points[STRIP_RAYS];
    RayCounts counts = {0};
    pass->renderer->settings.engine->survey(pass->renderer->tracer, strip,
                                            layer_wants(layering->layer), points, &counts);
    for (int row = 0; row < strip->rows; row++) {
        for (int column = 0; column < strip->columns; column++) {
            float *numbers = layering->numbers + LAYER_NUMBERS * cell_of(pass, strip, column, row);
            layer_numbers(layering->layer, &points[row * strip->columns + column], numbers);
        }
    }
    return counts;
}

/** Asks both tracers about the paths of a strip. @param pass The pass. @param strip The rays.
 *  @return How many were traced, by the engine that is judged. */
static RayCounts strip_faults(const LayerPass *pass, const PixelGrid *strip) {
    const Layering *layering = pass->layering;
    SurveyPoint points[STRIP_RAYS], truths[STRIP_RAYS];
    RayCounts counts = {0}, others = {0};
    pass->renderer->settings.engine->survey(pass->renderer->tracer, strip, SURVEY_LIGHT, points,
                                            &counts);
    layering->reference->survey(layering->truth, strip, SURVEY_LIGHT, truths, &others);
    for (int row = 0; row < strip->rows; row++) {
        for (int column = 0; column < strip->columns; column++) {
            size_t cell = cell_of(pass, strip, column, row), i = (size_t)(row * strip->columns);
            float *numbers = layering->numbers + LAYER_NUMBERS * cell;
            i += (size_t)column;
            numbers[0] = brightness(pass, truths[i].color);
            numbers[1] = (float)fault_of(&points[i], &truths[i]);
            layering->marks[cell] = mark_of(&truths[i]);
        }
    }
    return counts;
}

/** Asks both tracers about the colours of a strip; or only the one that is judged. @param pass The
 *  pass. @param strip The rays. @return How many were traced, by the engine that is judged. */
static RayCounts strip_error(const LayerPass *pass, const PixelGrid *strip) {
    const Layering *layering = pass->layering;
    double seen[3 * STRIP_RAYS], truth[3 * STRIP_RAYS];
    RayCounts counts = {0}, others = {0};
    size_t rays = (size_t)strip->columns * (size_t)strip->rows;
    pass->renderer->settings.engine->trace(pass->renderer->tracer, strip, seen, &counts);
    if (pass->compares) {
        layering->reference->trace(layering->truth, strip, truth, &others);
    }
    for (size_t i = 0; i < rays; i++) {
        int column = (int)(i % (size_t)strip->columns), row = (int)(i / (size_t)strip->columns);
        const double a[3] = {seen[i], seen[rays + i], seen[2 * rays + i]};
        const double b[3] = {truth[i], truth[rays + i], truth[2 * rays + i]};
        float *numbers = layering->numbers + LAYER_NUMBERS * cell_of(pass, strip, column, row);
        numbers[0] = pass->compares ? steps_between(a, b) : NAN;
        numbers[1] = pass->compares ? 0 : brightness(pass, a);
    }
    return counts;
}

/** Keeps the ends of a block's numbers. @param pass The pass. @param grid Its rays. @param index
 *  Which block. */
static void ends_keep(const LayerPass *pass, const PixelGrid *grid, size_t index) {
    double *ends = pass->layering->ends + 2 * index;
    ends[0] = HUGE_VAL;
    ends[1] = -HUGE_VAL;
    for (int row = 0; row < grid->rows; row++) {
        for (int column = 0; column < grid->columns; column++) {
            size_t cell = cell_of(pass, grid, column, row);
            double number = (double)pass->layering->numbers[LAYER_NUMBERS * cell];
            ends[0] = number < ends[0] ? number : ends[0];
            ends[1] = number > ends[1] ? number : ends[1];
        }
    }
}

void measure_block(void *context, size_t index) {
    LayerPass *pass = context;
    Layer layer = pass->layering->layer;
    PixelGrid block = drawing_block(pass->width, pass->height, index);
    const PixelGrid grid = drawing_grid(&block, pass->stride);
    int rows = pass->renderer->settings.engine->lanes > 1 ? STRIP_ROWS : 1;
    for (int row = 0; row < grid.rows && !is_stopped(pass); row += rows) {
        PixelGrid strip = grid;
        strip.y += row * grid.stride;
        strip.rows = grid.rows - row < rows ? grid.rows - row : rows;
        RayCounts counts = layer == LAYER_ACNE    ? strip_faults(pass, &strip)
                           : layer == LAYER_ERROR ? strip_error(pass, &strip)
                                                  : strip_survey(pass, &strip);
        atomic_fetch_add_explicit(&pass->rays, ray_counts_sum(&counts), memory_order_relaxed);
    }
    ends_keep(pass, &grid, index);
}

/* --- time ------------------------------------------------------------------------------------- */

/** Takes the time of a few pixels. @param pass The pass. @param few The pixels, all of them.
 *  @return Nanoseconds each. */
static float pixels_time(LayerPass *pass, const PixelGrid *few) {
    double colors[3 * STRIP_RAYS];
    RayCounts counts = {0};
    double start = clock_seconds();
    pass->renderer->settings.engine->trace(pass->renderer->tracer, few, colors, &counts);
    double seconds = clock_seconds() - start;
    atomic_fetch_add_explicit(&pass->rays, ray_counts_sum(&counts), memory_order_relaxed);
    return (float)(seconds * 1e9 / (few->columns * few->rows));
}

/** Notes the time of pixels: the shortest so far. @param pass The pass. @param grid Their cells.
 *  @param time Nanoseconds each. */
static void time_note(const LayerPass *pass, const PixelGrid *grid, float time) {
    for (int row = 0; row < grid->rows; row++) {
        for (int column = 0; column < grid->columns; column++) {
            size_t cell = cell_of(pass, grid, column, row);
            float *number = pass->layering->numbers + LAYER_NUMBERS * cell;
            *number = pass->repeat > 0 ? fminf(*number, time) : time;
        }
    }
}

/** @return As many pixels of a block as an engine takes at once. @param pass The pass. @param block
 *  The block. @param x Which column of it comes first. @param y Which row. */
static PixelGrid few_pixels(const LayerPass *pass, const PixelGrid *block, int x, int y) {
    int lanes = pass->renderer->settings.engine->lanes;
    int columns = lanes == 1 ? SINGLE_COLUMNS : lanes > STRIP_ROWS ? lanes : STRIP_ROWS;
    int rows = lanes == 1 ? SINGLE_ROWS : STRIP_ROWS;
    PixelGrid few = {.x = block->x + x, .y = block->y + y, .stride = 1};
    few.columns = block->columns - x < columns ? block->columns - x : columns;
    few.rows = block->rows - y < rows ? block->rows - y : rows;
    return few;
}

void measure_time(void *context, size_t index) {
    LayerPass *pass = context;
    const PixelGrid block = drawing_block(pass->width, pass->height, index);
    const PixelGrid cells = drawing_grid(&block, pass->stride);
    if (pass->repeat < 0) {
        const PixelGrid few = few_pixels(pass, &block, block.columns / 2, block.rows / 2);
        time_note(pass, &cells, pixels_time(pass, &few));
    }
    const PixelGrid step = few_pixels(pass, &block, 0, 0);
    for (int y = 0; pass->repeat >= 0 && y < block.rows; y += step.rows) {
        for (int x = 0; x < block.columns && !is_stopped(pass); x += step.columns) {
            const PixelGrid few = few_pixels(pass, &block, x, y);
            time_note(pass, &few, pixels_time(pass, &few));
        }
    }
    ends_keep(pass, &cells, index);
}
