/**
 * @file
 * @brief Drawing layers: first the numbers of all pixels, block by block, then their scale, then
 *        their colours.
 *
 * Error, acne and leaks are found by asking a second tracer the same. Where a ray passes an edge
 * within a rounding, either side is right: a fault only counts where the reference sees the same in
 * the pixels around.
 */
#include "render/layer_renderer.h"

#include <stdlib.h>
#include <string.h>

/** How often the time of each pixel is taken; the shortest counts. */
enum { TIME_REPEATS = 5 };

void renderer_set_layer(Renderer *renderer, Layer layer) {
    renderer_stop(renderer);
    renderer->layer_renderer.layer = layer;
}

/* --- what it needs ---------------------------------------------------------------------------- */

/** Forgets the tracer that it compares with. */
static void reference_tracer_destroy(LayerRenderer *layer_renderer) {
    if (layer_renderer->reference) {
        layer_renderer->reference->destroy(layer_renderer->reference_tracer);
        layer_renderer->reference = NULL;
        layer_renderer->reference_tracer = NULL;
    }
}

/** Forgets the numbers of all pixels. */
static void layer_values_deinit(LayerRenderer *layer_renderer) {
    free(layer_renderer->values);
    free(layer_renderer->path_hashes);
    free(layer_renderer->ranges);
    layer_renderer->values = NULL;
    layer_renderer->path_hashes = NULL;
    layer_renderer->ranges = NULL;
    layer_renderer->capacity = 0;
}

void layer_renderer_deinit(Renderer *renderer) {
    reference_tracer_destroy(&renderer->layer_renderer);
    layer_values_deinit(&renderer->layer_renderer);
}

/** @return The engine that a layer compares with: the widest, or double where that is what is
 *  judged or where paths are all that counts. */
static const Engine *reference_engine_for(const Renderer *renderer) {
    enum { DOUBLE_BITS = 53 };
    bool needs_more_than_double = renderer->layer_renderer.layer == LAYER_ERROR &&
                                  renderer->settings.engine->mantissa_bits <= DOUBLE_BITS;
    return engine_with_role(needs_more_than_double ? ENGINE_REFERENCE : ENGINE_DOUBLE);
}

/** Makes the tracer that a layer compares with. @return Whether it is there. */
static bool reference_tracer_prepare(Renderer *renderer, const Scene *scene, Error *error) {
    LayerRenderer *layer_renderer = &renderer->layer_renderer;
    const Engine *reference = reference_engine_for(renderer);
    if (layer_renderer->reference_tracer && layer_renderer->reference == reference) {
        return true;
    }
    reference_tracer_destroy(layer_renderer);
    TraceSettings settings = renderer_trace_settings(renderer, NULL);
    settings.offset = OFFSET_BOUND;
    Scene lit = renderer_lit_scene(renderer, scene);
    layer_renderer->reference_tracer = reference->create_tracer(&lit, &settings, error);
    layer_renderer->reference = layer_renderer->reference_tracer ? reference : NULL;
    return layer_renderer->reference_tracer != NULL;
}

/** Makes room for a layer. @return false without memory. */
static bool layer_values_resize(LayerRenderer *layer_renderer, int width, int height,
                                Error *error) {
    size_t pixels = (size_t)width * (size_t)height;
    if (layer_renderer->capacity >= pixels) {
        return true;
    }
    layer_values_deinit(layer_renderer);
    layer_renderer->values = calloc(pixels, LAYER_VALUES * sizeof *layer_renderer->values);
    layer_renderer->path_hashes = calloc(pixels, sizeof *layer_renderer->path_hashes);
    layer_renderer->ranges = calloc(pixels, 2 * sizeof *layer_renderer->ranges);
    if (!layer_renderer->values || !layer_renderer->path_hashes || !layer_renderer->ranges) {
        return error_set(error, STATUS_FAILED, "no memory for a layer");
    }
    layer_renderer->capacity = pixels;
    return true;
}

bool layer_renderer_prepare(Renderer *renderer, const Scene *scene, int width, int height,
                            Error *error) {
    LayerRenderer *layer_renderer = &renderer->layer_renderer;
    if (layer_renderer->layer == LAYER_SHADED) {
        layer_renderer_deinit(renderer);
        return true;
    }
    if (!layer_values_resize(layer_renderer, width, height, error)) {
        return false;
    }
    if (layer_needs_reference(layer_renderer->layer)) {
        if (!reference_tracer_prepare(renderer, scene, error)) {
            return false;
        }
        layer_renderer->reference->set_view(layer_renderer->reference_tracer, scene, width, height);
    }
    return true;
}

/* --- colours ---------------------------------------------------------------------------------- */

/** @return Whether the reference sees the same in the cells around one. */
static bool is_reference_uniform(const LayerPass *pass, size_t cell) {
    const uint32_t *hashes = pass->layer_renderer->path_hashes;
    size_t columns = layer_pass_columns(pass);
    size_t rows = ((size_t)pass->height + (size_t)pass->stride - 1) / (size_t)pass->stride;
    size_t x = cell % columns, y = cell / columns;
    return (x == 0 || hashes[cell - 1] == hashes[cell]) &&
           (x + 1 == columns || hashes[cell + 1] == hashes[cell]) &&
           (y == 0 || hashes[cell - columns] == hashes[cell]) &&
           (y + 1 == rows || hashes[cell + columns] == hashes[cell]);
}

/** Colours a cell, and counts what is wrong with it. */
static void cell_color(LayerPass *pass, size_t cell, uint8_t rgb[3]) {
    const LayerRenderer *layer_renderer = pass->layer_renderer;
    float values[LAYER_VALUES];
    memcpy(values, layer_renderer->values + LAYER_VALUES * cell, sizeof values);
    if (layer_renderer->layer == LAYER_ACNE && values[1] > ARTIFACT_NONE) {
        values[1] = is_reference_uniform(pass, cell) ? values[1] : ARTIFACT_NONE;
        bool is_acne = (int)values[1] == ARTIFACT_ACNE, is_leak = (int)values[1] == ARTIFACT_LEAK;
        atomic_fetch_add_explicit(&pass->artifact_pixels, is_acne, memory_order_relaxed);
        atomic_fetch_add_explicit(&pass->leak_pixels, is_leak, memory_order_relaxed);
    } else if (layer_renderer->layer == LAYER_ERROR && values[0] > 1) {
        atomic_fetch_add_explicit(&pass->artifact_pixels, 1, memory_order_relaxed);
    }
    layer_color(layer_renderer->layer, &pass->scale, values, rgb);
}

/**
 * Fills the pixels of a cell.
 * @param tile  The block that it is in.
 * @param column  Its column of cells there.
 */
static void cell_fill_pixels(const LayerPass *pass, const PixelGrid *tile, int column, int row,
                             const uint8_t rgb[3]) {
    for (int y = row * pass->stride; y < (row + 1) * pass->stride && y < tile->rows; y++) {
        size_t first_pixel = (size_t)(tile->y + y) * (size_t)pass->width + (size_t)tile->x;
        for (int x = column * pass->stride; x < (column + 1) * pass->stride && x < tile->columns;
             x++) {
            memcpy(pass->picture->pixels + 3 * (first_pixel + (size_t)x), rgb, 3);
        }
    }
}

/** Colours a block. See #ThreadPoolTask. */
static void tile_color(void *context, size_t index) {
    LayerPass *pass = context;
    PixelGrid tile = tile_at(pass->width, pass->height, index);
    const PixelGrid grid = tile_subsample(&tile, pass->stride);
    for (int row = 0; row < grid.rows; row++) {
        size_t cell = layer_pass_cell_index(pass, &grid, 0,
                                            row); // With a stride of 1 also the pixel's place.
        for (int column = 0; column < grid.columns; column++, cell++) {
            uint8_t rgb[3];
            cell_color(pass, cell, rgb);
            if (pass->stride == 1) {
                memcpy(pass->picture->pixels + 3 * cell, rgb, 3);
            } else {
                cell_fill_pixels(pass, &tile, column, row, rgb);
            }
        }
    }
    atomic_fetch_add_explicit(&pass->pixel_count, (uint64_t)(grid.columns * grid.rows),
                              memory_order_relaxed);
}

/* --- passes ----------------------------------------------------------------------------------- */

/** @return The scale of a pass whose pixels are measured. */
static LayerScale layer_pass_scale(const LayerPass *pass) {
    double low = HUGE_VAL, high = -HUGE_VAL;
    size_t tiles = tile_count(pass->width, pass->height);
    for (size_t i = 0; i < tiles; i++) {
        low = fmin(low, pass->layer_renderer->ranges[2 * i]);
        high = fmax(high, pass->layer_renderer->ranges[2 * i + 1]);
    }
    return layer_scale(pass->layer_renderer->layer, low, high);
}

/**
 * Finds the next pass.
 * @param[in,out] pass  The pass that has ended; `stride` 0 before the first.
 * @return false after the last pass.
 */
static bool layer_pass_next(Layer layer, LayerPass *pass) {
    if (layer == LAYER_TIME) {
        pass->repeat = pass->stride == 0 ? -1 : pass->repeat + 1;
        pass->stride = pass->repeat < 0 ? COARSEST_STRIDE : 1;
        return pass->repeat < TIME_REPEATS;
    }
    if (pass->stride == 0) {
        pass->stride = COARSEST_STRIDE;
        pass->uses_reference =
            layer != LAYER_ERROR; // Its reference may be slow: something comes first.
        return true;
    }
    pass->stride = pass->uses_reference ? pass->stride / 2 : pass->stride;
    pass->uses_reference = true;
    return pass->stride > 0;
}

/**
 * @return How a pass stands.
 * @param seconds  Since the first began.
 * @param is_last  Whether it was the last.
 */
static RenderStats layer_pass_stats(const LayerPass *pass, double seconds, bool is_last) {
    return (RenderStats){.seconds = seconds,
                         .full_resolution_seconds = pass->stride == 1 ? seconds : 0,
                         .rays = {.camera = atomic_load(&pass->ray_count)},
                         .stride = pass->stride,
                         .samples = 1,
                         .progress = is_last ? 1 : 1.0 / (pass->stride * pass->stride),
                         .is_finished = is_last,
                         .layer = {.layer = pass->layer_renderer->layer,
                                   .scale = pass->scale,
                                   .pixel_count = atomic_load(&pass->pixel_count),
                                   .artifact_pixels = atomic_load(&pass->artifact_pixels),
                                   .leak_pixels = atomic_load(&pass->leak_pixels)}};
}

/** Draws a pass. @return false when it was stopped. */
static bool layer_pass_render(LayerPass *pass) {
    ThreadPool *thread_pool = pass->renderer->thread_pool;
    size_t tiles = tile_count(pass->width, pass->height);
    pass->pixel_count = pass->artifact_pixels = pass->leak_pixels = 0;
    thread_pool_run(
        thread_pool, tiles,
        pass->layer_renderer->layer == LAYER_TIME ? layer_time_tile : layer_measure_tile, pass);
    if (layer_pass_is_stopped(pass)) {
        return false;
    }
    pass->scale = layer_pass_scale(pass);
    thread_pool_run(thread_pool, tiles, tile_color, pass);
    return !layer_pass_is_stopped(pass);
}

void layer_renderer_render(Renderer *renderer) {
    BackgroundRenderer *background = &renderer->background;
    double start = clock_now_seconds();
    LayerPass pass = {.renderer = renderer,
                      .layer_renderer = &renderer->layer_renderer,
                      .width = background->width,
                      .height = background->height};
    bool is_more = layer_pass_next(renderer->layer_renderer.layer, &pass);
    while (is_more) {
        pass.picture = &background->back;
        if (!layer_pass_render(&pass)) {
            return;
        }
        LayerPass finished = pass;
        is_more = layer_pass_next(renderer->layer_renderer.layer, &pass);
        RenderStats stats = layer_pass_stats(&finished, clock_now_seconds() - start, !is_more);
        background_renderer_publish(renderer, &stats);
    }
}
