/**
 * @file
 * @brief Drawing layers: first the numbers of all pixels, block by block, then their scale, then
 *        their colours.
 *
 * Error, acne and leaks are found by asking a second tracer the same. Where a ray passes an edge
 * within a rounding, either side is right: a fault only counts where the reference sees the same in
 * the pixels around.
 */
#include "render/layering.h"

#include <stdlib.h>
#include <string.h>

/** How often the time of each pixel is taken; the shortest counts. */
enum { TIME_REPEATS = 5 };

void renderer_set_layer(Renderer *renderer, Layer layer) {
    renderer_stop(renderer);
    renderer->layering.layer = layer;
}

/* --- what it needs ---------------------------------------------------------------------------- */

/** Forgets the tracer that it compares with. @param layering It. */
static void truth_release(Layering *layering) {
    if (layering->reference) {
        layering->reference->release(layering->truth);
        layering->reference = NULL;
        layering->truth = NULL;
    }
}

/** Forgets the numbers of all pixels. @param layering It. */
static void numbers_release(Layering *layering) {
    free(layering->numbers);
    free(layering->marks);
    free(layering->ends);
    layering->numbers = NULL;
    layering->marks = NULL;
    layering->ends = NULL;
    layering->pixels = 0;
}

void layering_release(Renderer *renderer) {
    truth_release(&renderer->layering);
    numbers_release(&renderer->layering);
}

/** @return The engine that a layer compares with: the widest, or double where that is what is
 *          judged or where paths are all that counts. @param renderer The renderer. */
static const Engine *reference_of(const Renderer *renderer) {
    enum { DOUBLE_BITS = 53 };
    bool wants_widest = renderer->layering.layer == LAYER_ERROR &&
                        renderer->settings.engine->mantissa_bits <= DOUBLE_BITS;
    const Engine *found = NULL;
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        bool is_wide = (*engine)->mantissa_bits > DOUBLE_BITS;
        bool is_double = (*engine)->mantissa_bits == DOUBLE_BITS;
        if (!found && (wants_widest ? is_wide : is_double) && engine_is_supported(*engine)) {
            found = *engine;
        }
    }
    return found;
}

/** Makes the tracer that a layer compares with. @param renderer The renderer. @param scene The
 *  scene. @param[out] error What is wrong. @return Whether it is there. */
static bool truth_prepare(Renderer *renderer, const Scene *scene, Error *error) {
    Layering *layering = &renderer->layering;
    const Engine *reference = reference_of(renderer);
    if (layering->truth && layering->reference == reference) {
        return true;
    }
    truth_release(layering);
    TraceSettings settings = renderer_trace_settings(renderer, NULL);
    settings.offset = OFFSET_BOUND;
    Scene lit = renderer_scene(renderer, scene);
    layering->truth = reference->prepare(&lit, &settings, error);
    layering->reference = layering->truth ? reference : NULL;
    return layering->truth != NULL;
}

/** Makes room for a layer. @param layering It. @param width Pixels. @param height Pixels.
 *  @param[out] error What is wrong. @return false without memory. */
static bool numbers_resize(Layering *layering, int width, int height, Error *error) {
    size_t pixels = (size_t)width * (size_t)height;
    if (layering->pixels >= pixels) {
        return true;
    }
    numbers_release(layering);
    layering->numbers = calloc(pixels, LAYER_NUMBERS * sizeof *layering->numbers);
    layering->marks = calloc(pixels, sizeof *layering->marks);
    layering->ends = calloc(pixels, 2 * sizeof *layering->ends);
    if (!layering->numbers || !layering->marks || !layering->ends) {
        return error_set(error, STATUS_FAILED, "no memory for a layer");
    }
    layering->pixels = pixels;
    return true;
}

bool layering_look(Renderer *renderer, const Scene *scene, int width, int height, Error *error) {
    Layering *layering = &renderer->layering;
    if (layering->layer == LAYER_SHADED) {
        layering_release(renderer);
        return true;
    }
    if (!numbers_resize(layering, width, height, error)) {
        return false;
    }
    if (layer_compares(layering->layer)) {
        if (!truth_prepare(renderer, scene, error)) {
            return false;
        }
        layering->reference->look(layering->truth, scene, width, height);
    }
    return true;
}

/* --- colours ---------------------------------------------------------------------------------- */

/** @return Whether the reference sees the same in the cells around one. @param pass The pass.
 *  @param cell Which. */
static bool is_calm(const LayerPass *pass, size_t cell) {
    const uint32_t *marks = pass->layering->marks;
    size_t across = cells_across(pass);
    size_t down = ((size_t)pass->height + (size_t)pass->stride - 1) / (size_t)pass->stride;
    size_t x = cell % across, y = cell / across;
    return (x == 0 || marks[cell - 1] == marks[cell]) &&
           (x + 1 == across || marks[cell + 1] == marks[cell]) &&
           (y == 0 || marks[cell - across] == marks[cell]) &&
           (y + 1 == down || marks[cell + across] == marks[cell]);
}

/** Colours a cell, and counts what is wrong with it. @param pass The pass. @param cell Which.
 *  @param[out] rgb Its colour. */
static void cell_color(LayerPass *pass, size_t cell, uint8_t rgb[3]) {
    const Layering *layering = pass->layering;
    float numbers[LAYER_NUMBERS];
    memcpy(numbers, layering->numbers + LAYER_NUMBERS * cell, sizeof numbers);
    if (layering->layer == LAYER_ACNE && numbers[1] > FAULT_NONE) {
        numbers[1] = is_calm(pass, cell) ? numbers[1] : FAULT_NONE;
        bool is_acne = (int)numbers[1] == FAULT_ACNE, is_leak = (int)numbers[1] == FAULT_LEAK;
        atomic_fetch_add_explicit(&pass->faults, is_acne, memory_order_relaxed);
        atomic_fetch_add_explicit(&pass->leaks, is_leak, memory_order_relaxed);
    } else if (layering->layer == LAYER_ERROR && numbers[0] > 1) {
        atomic_fetch_add_explicit(&pass->faults, 1, memory_order_relaxed);
    }
    layer_color(layering->layer, &pass->scale, numbers, rgb);
}

/** Fills the pixels of a cell. @param pass The pass. @param block The block that it is in.
 *  @param column Its column of cells there. @param row Its row. @param rgb Its colour. */
static void cell_fill(const LayerPass *pass, const PixelGrid *block, int column, int row,
                      const uint8_t rgb[3]) {
    for (int y = row * pass->stride; y < (row + 1) * pass->stride && y < block->rows; y++) {
        size_t line = (size_t)(block->y + y) * (size_t)pass->width + (size_t)block->x;
        for (int x = column * pass->stride; x < (column + 1) * pass->stride && x < block->columns;
             x++) {
            memcpy(pass->picture->pixels + 3 * (line + (size_t)x), rgb, 3);
        }
    }
}

/** Colours a block. See #WorkersJob. @param context The pass. @param index Which block. */
static void block_color(void *context, size_t index) {
    LayerPass *pass = context;
    PixelGrid block = drawing_block(pass->width, pass->height, index);
    const PixelGrid grid = drawing_grid(&block, pass->stride);
    for (int row = 0; row < grid.rows; row++) {
        size_t cell = cell_of(pass, &grid, 0, row); // With a stride of 1 also the pixel's place.
        for (int column = 0; column < grid.columns; column++, cell++) {
            uint8_t rgb[3];
            cell_color(pass, cell, rgb);
            if (pass->stride == 1) {
                memcpy(pass->picture->pixels + 3 * cell, rgb, 3);
            } else {
                cell_fill(pass, &block, column, row, rgb);
            }
        }
    }
    atomic_fetch_add_explicit(&pass->pixels, (uint64_t)(grid.columns * grid.rows),
                              memory_order_relaxed);
}

/* --- passes ----------------------------------------------------------------------------------- */

/** @return The scale of a pass whose pixels are measured. @param pass The pass. */
static LayerScale pass_scale(const LayerPass *pass) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    size_t blocks = drawing_blocks(pass->width, pass->height);
    for (size_t i = 0; i < blocks; i++) {
        low = fmin(low, pass->layering->ends[2 * i]);
        high = fmax(high, pass->layering->ends[2 * i + 1]);
    }
    return layer_scale(pass->layering->layer, low, high);
}

/**
 * Finds the next pass.
 * @param layer         The layer.
 * @param[in,out] pass  The pass that has ended; `stride` 0 before the first.
 * @return false after the last pass.
 */
static bool pass_next(Layer layer, LayerPass *pass) {
    if (layer == LAYER_TIME) {
        pass->repeat = pass->stride == 0 ? -1 : pass->repeat + 1;
        pass->stride = pass->repeat < 0 ? COARSEST_STRIDE : 1;
        return pass->repeat < TIME_REPEATS;
    }
    if (pass->stride == 0) {
        pass->stride = COARSEST_STRIDE;
        pass->compares = layer != LAYER_ERROR; // Its reference may be slow: something comes first.
        return true;
    }
    pass->stride = pass->compares ? pass->stride / 2 : pass->stride;
    pass->compares = true;
    return pass->stride > 0;
}

/** @return How a pass stands. @param pass The pass. @param seconds Since the first began.
 *  @param is_last Whether it was the last. */
static RenderReport pass_report(const LayerPass *pass, double seconds, bool is_last) {
    return (RenderReport){.seconds = seconds,
                          .whole_seconds = pass->stride == 1 ? seconds : 0,
                          .rays = {.camera = atomic_load(&pass->rays)},
                          .stride = pass->stride,
                          .samples = 1,
                          .share = is_last ? 1 : 1.0 / (pass->stride * pass->stride),
                          .is_finished = is_last,
                          .layer = {.layer = pass->layering->layer,
                                    .scale = pass->scale,
                                    .pixels = atomic_load(&pass->pixels),
                                    .faults = atomic_load(&pass->faults),
                                    .leaks = atomic_load(&pass->leaks)}};
}

/** Draws a pass. @param pass The pass. @return false when it was stopped. */
static bool pass_draw(LayerPass *pass) {
    Workers *workers = pass->renderer->workers;
    size_t blocks = drawing_blocks(pass->width, pass->height);
    pass->pixels = pass->faults = pass->leaks = 0;
    workers_run(workers, blocks, pass->layering->layer == LAYER_TIME ? measure_time : measure_block,
                pass);
    if (is_stopped(pass)) {
        return false;
    }
    pass->scale = pass_scale(pass);
    workers_run(workers, blocks, block_color, pass);
    return !is_stopped(pass);
}

void layering_draw(Renderer *renderer) {
    Background *background = &renderer->background;
    double start = clock_seconds();
    LayerPass pass = {.renderer = renderer,
                      .layering = &renderer->layering,
                      .width = background->width,
                      .height = background->height};
    bool is_more = pass_next(renderer->layering.layer, &pass);
    while (is_more) {
        pass.picture = &background->back;
        if (!pass_draw(&pass)) {
            return;
        }
        LayerPass drawn = pass;
        is_more = pass_next(renderer->layering.layer, &pass);
        RenderReport report = pass_report(&drawn, clock_seconds() - start, !is_more);
        background_publish(renderer, &report);
    }
}
