/**
 * @file
 * @brief The numbers of layers, measured tile by tile.
 *
 * Error, acne and leaks come from a second tracer, the reference, that traces the same rays. Where
 * a ray passes an edge within a rounding, either side is right: an artefact only counts where the
 * reference has the same path in the pixels around.
 */
#include "base/encoding.h"
#include "render/layer_renderer.h"
#include "render/rounding_witness.h"

/** Rows of rays that an engine of many lanes traces at once; between strips a pass can stop.
 * Engines of one lane, which are slow, trace one row, and so does an engine that is compared with
 * one. */
enum { STRIP_ROWS = 8 };
/** Rays of a strip, at most. */
enum { STRIP_RAYS = TILE_COLUMNS * STRIP_ROWS };
/** Columns and rows of rays whose time an engine of one lane takes together. */
enum { TIMING_GROUP_COLUMNS = 4, TIMING_GROUP_ROWS = 2 };

/** @return Perceived brightness of a pixel, 0 to 1, dimmed so that marked pixels stand out. */
static float perceived_brightness(const RenderPass *pass, const double color[3]) {
    /** Brightness of white. */
    const float dimming = 0.75F;
    // The luminance of the primaries of sRGB (ITU-R BT.709).
    double luminance = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    uint8_t code = encoder_encode(pass->encoder, (float)luminance);
    return (float)code / ENCODING_CODE_MAXIMUM * dimming;
}

/** @return The largest difference of a channel, in steps of 8 bits. */
static float code_difference(const double a[3], const double b[3]) {
    double largest = 0;
    for (int i = 0; i < 3; i++) {
        largest =
            fmax(largest, fabs(encoding_difference(ENCODING_SRGB, fmin(a[i], 1), fmin(b[i], 1))));
    }
    return (float)largest;
}

/** @return The largest of the three differences of three colours. See #code_difference. */
static float largest_difference(const double a[3], const double b[3], const double c[3]) {
    return fmaxf(code_difference(a, b), fmaxf(code_difference(b, c), code_difference(c, a)));
}

/** @return Path hash of a pixel: equal where its rays hit the same shapes and lights. */
static uint32_t path_hash_of(const AovSample *sample) {
    /** Multiplier of a linear congruential generator (Knuth, MMIX). */
    const uint64_t multiplier = UINT64_C(6364136223846793005);
    uint64_t hash = (sample->lights_occluded + 1) * multiplier + sample->lights_tested;
    for (uint32_t i = 0; i < sample->secondary_count; i++) {
        hash = hash * multiplier + (uint64_t)(sample->secondary_shapes[i] + 2);
    }
    return (uint32_t)((hash * multiplier) >> 32);
}

/** @return The artefact of a pixel, whose AOVs two engines have traced. */
static ShadingArtifact compare_paths(const AovSample *sample, const AovSample *reference) {
    if (sample->shape != reference->shape || sample->shape < 0) {
        return ARTIFACT_NONE;
    }
    uint64_t tested_by_both = sample->lights_tested & reference->lights_tested,
             different = (sample->lights_occluded ^ reference->lights_occluded) & tested_by_both;
    if (different) {
        return sample->lights_occluded & different ? ARTIFACT_ACNE : ARTIFACT_LEAK;
    }
    for (uint32_t i = 0; i < sample->secondary_count && i < reference->secondary_count; i++) {
        if (sample->secondary_shapes[i] != reference->secondary_shapes[i]) {
            return sample->secondary_shapes[i] == sample->shape ? ARTIFACT_ACNE : ARTIFACT_LEAK;
        }
    }
    return ARTIFACT_NONE;
}

/** Measures a strip by its AOVs. See #LayerClass.measure. */
static void measure_aovs(const RenderPass *pass, const PixelGrid *strip, RayCounts *counts) {
    AovSample samples[STRIP_RAYS];
    const LayerClass *layer = layer_class(pass->layer);
    pass->engine->trace_aovs(pass->tracer, strip, layer->aov_mask, samples, counts);
    for (int row = 0; row < strip->rows; row++) {
        for (int column = 0; column < strip->columns; column++) {
            layer->read(&samples[row * strip->columns + column],
                        layer_cell_values(pass, strip, column, row));
        }
    }
}

void measure_artifacts(const RenderPass *pass, const PixelGrid *strip, RayCounts *counts) {
    const LayerRenderer *layer_renderer = &pass->renderer->layer_renderer;
    AovSample samples[STRIP_RAYS], reference_samples[STRIP_RAYS];
    RayCounts reference_counts = {0};
    pass->engine->trace_aovs(pass->tracer, strip, AOV_RADIANCE, samples, counts);
    layer_renderer->reference->trace_aovs(layer_renderer->reference_tracer, strip, AOV_RADIANCE,
                                          reference_samples, &reference_counts);
    for (int row = 0; row < strip->rows; row++) {
        for (int column = 0; column < strip->columns; column++) {
            size_t cell = layer_cell_index(pass, strip, column, row);
            size_t i = (size_t)(row * strip->columns + column);
            float *values = layer_renderer->values + LAYER_VALUES * cell;
            values[0] = perceived_brightness(pass, reference_samples[i].color);
            values[1] = (float)compare_paths(&samples[i], &reference_samples[i]);
            layer_renderer->path_hashes[cell] = path_hash_of(&reference_samples[i]);
        }
    }
}

/** Copies the light of one ray of a strip. @param rays Number of rays of the strip. */
static void read_color(const double *colors, size_t rays, size_t i, double color[3]) {
    for (size_t channel = 0; channel < 3; channel++) {
        color[channel] = colors[channel * rays + i];
    }
}

void measure_error(const RenderPass *pass, const PixelGrid *strip, RayCounts *counts) {
    const LayerRenderer *layer_renderer = &pass->renderer->layer_renderer;
    double colors[3 * STRIP_RAYS], reference_colors[3 * STRIP_RAYS];
    RayCounts reference_counts = {0};
    size_t rays = (size_t)strip->columns * (size_t)strip->rows;
    bool has_reference = !pass->range.is_preview;
    pass->engine->trace(pass->tracer, strip, colors, counts);
    if (has_reference) {
        layer_renderer->reference->trace(layer_renderer->reference_tracer, strip, reference_colors,
                                         &reference_counts);
    }
    for (size_t i = 0; i < rays; i++) {
        int column = (int)(i % (size_t)strip->columns), row = (int)(i / (size_t)strip->columns);
        double a[3], b[3];
        read_color(colors, rays, i, a);
        float *values = layer_cell_values(pass, strip, column, row);
        if (has_reference) {
            read_color(reference_colors, rays, i, b);
        }
        values[0] = has_reference ? code_difference(a, b) : NAN;
        values[1] = has_reference ? 0 : perceived_brightness(pass, a);
    }
}

void measure_rounding(const RenderPass *pass, const PixelGrid *strip, RayCounts *counts) {
    double nearest[3 * STRIP_RAYS], upward[3 * STRIP_RAYS], downward[3 * STRIP_RAYS];
    RayCounts other_counts = {0};
    size_t rays = (size_t)strip->columns * (size_t)strip->rows;
    pass->engine->trace(pass->tracer, strip, nearest, counts);
    bool is_known =
        !pass->range.is_preview &&
        trace_rounded(pass->engine, ROUNDING_UPWARD, pass->tracer, strip, upward, &other_counts) &&
        trace_rounded(pass->engine, ROUNDING_DOWNWARD, pass->tracer, strip, downward,
                      &other_counts);
    for (size_t i = 0; i < rays; i++) {
        int column = (int)(i % (size_t)strip->columns), row = (int)(i / (size_t)strip->columns);
        double a[3], b[3], c[3];
        read_color(nearest, rays, i, a);
        float *values = layer_cell_values(pass, strip, column, row);
        if (is_known) {
            read_color(upward, rays, i, b);
            read_color(downward, rays, i, c);
        }
        values[0] = is_known ? largest_difference(a, b, c) : NAN;
        values[1] = is_known ? 0 : perceived_brightness(pass, a);
    }
}

void measure_time(const RenderPass *pass, const PixelGrid *strip, RayCounts *counts) {
    double colors[3 * STRIP_RAYS];
    double start = clock_now_seconds();
    pass->engine->trace(pass->tracer, strip, colors, counts);
    double seconds = clock_now_seconds() - start;
    float nanoseconds = (float)(seconds * 1e9 / (strip->columns * strip->rows));
    for (int row = 0; row < strip->rows; row++) {
        for (int column = 0; column < strip->columns; column++) {
            float *value = layer_cell_values(pass, strip, column, row);
            *value = pass->range.first_sample > 0 ? fminf(*value, nanoseconds) : nanoseconds;
        }
    }
}

/** @return Whether the reference has the same path in the pixels around one. */
static bool is_reference_uniform(const RenderPass *pass, size_t cell) {
    const uint32_t *hashes = pass->renderer->layer_renderer.path_hashes;
    size_t stride = (size_t)pass->range.stride, columns = layer_pass_columns(pass);
    size_t rows = ((size_t)pass->height + stride - 1) / stride;
    size_t x = cell % columns, y = cell / columns;
    return (x == 0 || hashes[cell - 1] == hashes[cell]) &&
           (x + 1 == columns || hashes[cell + 1] == hashes[cell]) &&
           (y == 0 || hashes[cell - columns] == hashes[cell]) &&
           (y + 1 == rows || hashes[cell + columns] == hashes[cell]);
}

ShadingArtifact classify_path(const RenderPass *pass, size_t cell, float values[LAYER_VALUES]) {
    if (values[1] > ARTIFACT_NONE && !is_reference_uniform(pass, cell)) {
        values[1] = ARTIFACT_NONE;
    }
    return (ShadingArtifact)values[1];
}

ShadingArtifact classify_error(const RenderPass *pass, size_t cell, float values[LAYER_VALUES]) {
    (void)pass, (void)cell;
    return values[0] > 1 ? ARTIFACT_ACNE : ARTIFACT_NONE;
}

/** Finds the least and greatest number of a tile. */
static void update_tile_range(const RenderPass *pass, const PixelGrid *grid, double *range) {
    range[0] = HUGE_VAL;
    range[1] = -HUGE_VAL;
    for (int row = 0; row < grid->rows; row++) {
        for (int column = 0; column < grid->columns; column++) {
            double value = (double)*layer_cell_values(pass, grid, column, row);
            range[0] = value < range[0] ? value : range[0];
            range[1] = value > range[1] ? value : range[1];
        }
    }
}

void layer_timing_block(const Engine *engine, int *columns, int *rows) {
    int lanes = engine->lanes;
    *columns = lanes == 1 ? TIMING_GROUP_COLUMNS : lanes > STRIP_ROWS ? lanes : STRIP_ROWS;
    *rows = lanes == 1 ? TIMING_GROUP_ROWS : STRIP_ROWS;
}

/** @return Whether an engine of one lane traces the rays of a pass. */
static bool is_slow(const RenderPass *pass) {
    bool has_reference =
        layer_class(pass->layer)->reference != REFERENCE_NONE && !pass->range.is_preview;
    return pass->engine->lanes == 1 ||
           (has_reference && pass->renderer->layer_renderer.reference->lanes == 1);
}

/** @return The strip of a tile that begins at a ray. @param column Its column in the grid. */
static PixelGrid strip_at(const RenderPass *pass, const PixelGrid *grid, int column, int row) {
    bool is_timed = layer_class(pass->layer)->is_timed;
    int columns = grid->columns, rows = is_slow(pass) ? 1 : STRIP_ROWS;
    if (is_timed) {
        layer_timing_block(pass->engine, &columns, &rows);
    }
    PixelGrid strip = *grid;
    strip.x += column * grid->stride;
    strip.y += row * grid->stride;
    strip.columns = grid->columns - column < columns ? grid->columns - column : columns;
    strip.rows = grid->rows - row < rows ? grid->rows - row : rows;
    return strip;
}

void layer_measure_tile(RenderPass *pass, const PixelGrid *tile, size_t index) {
    const LayerClass *layer = layer_class(pass->layer);
    const PixelGrid grid = tile_subsample(tile, pass->range.stride);
    RayCounts counts = {0};
    PixelGrid strip = grid;
    for (int row = 0; row < grid.rows; row += strip.rows) {
        for (int column = 0; column < grid.columns; column += strip.columns) {
            if (render_pass_is_stopped(pass)) {
                return;
            }
            strip = strip_at(pass, &grid, column, row);
            (layer->measure ? layer->measure : measure_aovs)(pass, &strip, &counts);
        }
    }
    update_tile_range(pass, &grid, pass->renderer->layer_renderer.ranges + 2 * index);
    render_pass_add_rays(pass, &counts, (size_t)grid.columns * (size_t)grid.rows);
}
