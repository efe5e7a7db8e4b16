/**
 * @file
 * @brief Layers: the numbers of all pixels are measured tile by tile; then come their scale and
 * their colours.
 */
#include "render/layer_renderer.h"

#include <stdlib.h>
#include <string.h>

void renderer_set_layer(Renderer *renderer, Layer layer) {
    renderer_stop(renderer);
    renderer->layer_renderer.layer = layer;
}

/* --- memory and reference --------------------------------------------------------------------- */

/** Destroys the reference tracer. */
static void reference_tracer_destroy(LayerRenderer *layer_renderer) {
    if (layer_renderer->reference) {
        layer_renderer->reference->destroy(layer_renderer->reference_tracer);
        layer_renderer->reference = NULL;
        layer_renderer->reference_tracer = NULL;
    }
}

/** Frees the numbers of all pixels. */
static void layer_values_deinit(LayerRenderer *layer_renderer) {
    free(layer_renderer->values);
    free(layer_renderer->front_values);
    free(layer_renderer->path_hashes);
    free(layer_renderer->ranges);
    layer_renderer->values = layer_renderer->front_values = NULL;
    layer_renderer->path_hashes = NULL;
    layer_renderer->ranges = NULL;
    layer_renderer->capacity = 0;
}

void layer_renderer_deinit(Renderer *renderer) {
    reference_tracer_destroy(&renderer->layer_renderer);
    layer_values_deinit(&renderer->layer_renderer);
}

/** @return The engine that the layer is compared with. */
static const Engine *reference_engine_for(const Renderer *renderer) {
    const Engine *widest = engine_with_role(ENGINE_REFERENCE);
    const Engine *double_engine = engine_with_role(ENGINE_DOUBLE);
    bool is_widest_wanted =
        widest && layer_class(renderer->layer_renderer.layer)->reference == REFERENCE_EXACT &&
        renderer->settings.engine->mantissa_bits < widest->mantissa_bits;
    return is_widest_wanted ? widest : double_engine;
}

/** Creates the reference tracer, if it is not there. @return Whether it is there. */
static bool reference_tracer_prepare(Renderer *renderer, const Scene *scene, Error *error) {
    LayerRenderer *layer_renderer = &renderer->layer_renderer;
    const Engine *reference = reference_engine_for(renderer);
    if (layer_renderer->reference_tracer && layer_renderer->reference == reference) {
        return true;
    }
    reference_tracer_destroy(layer_renderer);
    TraceSettings settings = renderer_trace_settings(renderer, NULL);
    // What the picture is compared with: the tracer's own methods, whatever it is traced with.
    RenderSettings own = renderer->settings;
    method_set_apply(METHODS_OWN, &own);
    settings.methods = own.trace.methods;
    settings.relaxation = own.trace.relaxation;
    settings.footprint = own.trace.footprint;
    settings.offset = OFFSET_BOUND;
    settings.pixel_point = PIXEL_CENTER;
    Scene lit = renderer_lit_scene(renderer, scene);
    layer_renderer->reference_tracer = reference->create_tracer(&lit, &settings, error);
    layer_renderer->reference = layer_renderer->reference_tracer ? reference : NULL;
    return layer_renderer->reference_tracer != NULL;
}

/** Allocates the numbers of all pixels. @return false without memory. */
static bool layer_values_resize(LayerRenderer *layer_renderer, int width, int height,
                                Error *error) {
    size_t pixels = (size_t)width * (size_t)height;
    if (layer_renderer->capacity >= pixels) {
        return true;
    }
    layer_values_deinit(layer_renderer);
    layer_renderer->values = calloc(pixels, LAYER_VALUES * sizeof *layer_renderer->values);
    layer_renderer->front_values =
        calloc(pixels, LAYER_VALUES * sizeof *layer_renderer->front_values);
    layer_renderer->path_hashes = calloc(pixels, sizeof *layer_renderer->path_hashes);
    layer_renderer->ranges = calloc(pixels, 2 * sizeof *layer_renderer->ranges);
    if (!layer_renderer->values || !layer_renderer->front_values || !layer_renderer->path_hashes ||
        !layer_renderer->ranges) {
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
    if (layer_class(layer_renderer->layer)->reference != REFERENCE_NONE) {
        if (!reference_tracer_prepare(renderer, scene, error)) {
            return false;
        }
        layer_renderer->reference->set_view(layer_renderer->reference_tracer, scene, width, height);
    }
    return true;
}

/* --- passes ----------------------------------------------------------------------------------- */

/** @return The scale of a pass whose rays are measured. */
static LayerScale scale_of_values(const RenderPass *pass) {
    const double *ranges = pass->renderer->layer_renderer.ranges;
    double low = HUGE_VAL, high = -HUGE_VAL;
    size_t tiles = tile_count(pass->width, pass->height);
    for (size_t i = 0; i < tiles; i++) {
        low = fmin(low, ranges[2 * i]);
        high = fmax(high, ranges[2 * i + 1]);
    }
    return layer_scale(pass->layer, low, high);
}

/**
 * Fills the pixels of a ray's cell.
 * @param tile  The tile that it is in.
 * @param column  Column of the cell in the tile.
 */
static void fill_cell(const RenderPass *pass, const PixelGrid *tile, int column, int row,
                      const uint8_t rgb[3]) {
    int stride = pass->range.stride;
    if (!pass->picture) {
        return;
    }
    for (int y = row * stride; y < (row + 1) * stride && y < tile->rows; y++) {
        size_t first_pixel = (size_t)(tile->y + y) * (size_t)pass->width + (size_t)tile->x;
        for (int x = column * stride; x < (column + 1) * stride && x < tile->columns; x++) {
            memcpy(pass->picture->pixels + 3 * (first_pixel + (size_t)x), rgb, 3);
        }
    }
}

/** Colours a tile whose rays are measured, and counts its artefacts. See #ShadeTile. */
static void color_tile(RenderPass *pass, const PixelGrid *tile, size_t index) {
    (void)index;
    const LayerClass *layer = layer_class(pass->layer);
    const PixelGrid grid = tile_subsample(tile, pass->range.stride);
    uint64_t counts[ARTIFACT_LEAK + 1] = {0};
    for (int row = 0; row < grid.rows; row++) {
        for (int column = 0; column < grid.columns; column++) {
            uint8_t rgb[3];
            size_t cell = layer_cell_index(pass, &grid, column, row);
            float *values = layer_cell_values(pass, &grid, column, row);
            if (layer->classify) {
                counts[layer->classify(pass, cell, values)]++;
            }
            layer_color(pass->layer, &pass->scale, values, rgb);
            fill_cell(pass, tile, column, row, rgb);
        }
    }
    atomic_fetch_add_explicit(&pass->artifact_pixels, counts[ARTIFACT_ACNE], memory_order_relaxed);
    atomic_fetch_add_explicit(&pass->leak_pixels, counts[ARTIFACT_LEAK], memory_order_relaxed);
    atomic_fetch_add_explicit(&pass->pixel_count, (uint64_t)(grid.columns * grid.rows),
                              memory_order_relaxed);
}

/** Adds a mark, unless there is one nearby or there are too many. @param x The pixel's column. */
static void marks_add(LayerMarks *marks, int x, int y) {
    for (size_t i = 0; i < marks->count; i++) {
        if (abs(marks->x[i] - x) <= LAYER_MARK_REACH && abs(marks->y[i] - y) <= LAYER_MARK_REACH) {
            return;
        }
    }
    if (marks->count == LAYER_MARKS_MAXIMUM) {
        *marks = (LayerMarks){.is_too_many = true};
        return;
    }
    marks->x[marks->count] = x;
    marks->y[marks->count++] = y;
}

/** Finds the marks of a pass whose rays are measured and classified. */
static void find_marks(const RenderPass *pass, LayerMarks *marks) {
    const LayerClass *layer = layer_class(pass->layer);
    size_t columns = layer_pass_columns(pass), stride = (size_t)pass->range.stride;
    size_t rows = ((size_t)pass->height + stride - 1) / stride;
    uint64_t left = atomic_load(&pass->artifact_pixels) + atomic_load(&pass->leak_pixels);
    *marks = (LayerMarks){.is_too_many = left > LAYER_MARKED_PIXELS};
    for (size_t cell = 0; left > 0 && !marks->is_too_many && cell < columns * rows; cell++) {
        float *values = pass->renderer->layer_renderer.values + LAYER_VALUES * cell;
        if (layer->classify(pass, cell, values) != ARTIFACT_NONE) {
            left--;
            marks_add(marks, (int)(cell % columns * stride + stride / 2),
                      (int)(cell / columns * stride + stride / 2));
        }
    }
}

bool render_pass_run_layer(RenderPass *pass) {
    pass->pixel_count = pass->artifact_pixels = pass->leak_pixels = 0;
    if (!render_pass_run_tiles(pass, layer_measure_tile)) {
        return false;
    }
    pass->scale = scale_of_values(pass);
    if (!render_pass_run_tiles(pass, color_tile)) {
        return false;
    }
    find_marks(pass, &pass->renderer->layer_renderer.marks);
    return true;
}

void layer_renderer_publish(Renderer *renderer, int width, int height) {
    LayerRenderer *layer_renderer = &renderer->layer_renderer;
    float *measured = layer_renderer->values;
    if (layer_renderer->layer == LAYER_SHADED) {
        return;
    }
    if (layer_class(layer_renderer->layer)->repeats > 0) {
        // The next pass improves these numbers.
        memcpy(layer_renderer->front_values, measured,
               (size_t)width * (size_t)height * LAYER_VALUES * sizeof *measured);
    } else {
        layer_renderer->values = layer_renderer->front_values;
        layer_renderer->front_values = measured;
    }
    layer_renderer->front_marks = layer_renderer->marks;
}

LayerPasses layer_passes(const Renderer *renderer) {
    const LayerClass *layer = layer_class(renderer->layer_renderer.layer);
    if (renderer->layer_renderer.layer == LAYER_SHADED) {
        return (LayerPasses){renderer->settings.samples, false, render_pass_run_samples};
    }
    return (LayerPasses){layer->repeats > 0 ? layer->repeats : 1, layer->has_preview,
                         render_pass_run_layer};
}

bool renderer_measure_layer(Renderer *renderer, const Scene *scene, Layer layer,
                            const atomic_bool *stop, LayerStats *stats, Error *error) {
    const RenderSettings *settings = &renderer->settings;
    Layer shown = renderer->layer_renderer.layer;
    renderer_set_layer(renderer, layer);
    bool is_done =
        layer_renderer_prepare(renderer, scene, settings->width, settings->height, error);
    if (is_done) {
        settings->engine->set_view(renderer->tracer, scene, settings->width, settings->height);
        RenderPass pass = renderer_make_pass(renderer, settings->width, settings->height, stop);
        pass.layer = layer;
        pass.range.stride = 1;
        is_done =
            render_pass_run_layer(&pass) || error_set(error, STATUS_INTERRUPTED, "interrupted");
        *stats = render_pass_stats(&pass, true).layer;
    }
    renderer_set_layer(renderer, shown);
    return is_done;
}
