/**
 * @file
 * @brief The numbers of layers, block by block.
 */
#include "render/layer_renderer.h"

#include "dioptre/encoding.h"

/** Rows of rays that are asked for at once by engines of many lanes; after each, a drawing can be
 *  stopped. Those of one lane, which are slow, take one. */
enum { STRIP_ROWS = 8 };
/** Rays of a strip, at most. */
enum { STRIP_RAYS = TILE_COLUMNS * STRIP_ROWS };
/** Columns and rows of pixels whose time is taken together by an engine of one lane. */
enum { TIMING_GROUP_COLUMNS = 4, TIMING_GROUP_ROWS = 2 };

/** @return A pixel's brightness, as it is seen, 0 to 1; faint, so that what is marked stands out.
 */
static float perceived_brightness(const LayerPass *pass, const double color[3]) {
    /** Of full light. */
    const float dimming = 0.75F;
    // The shares of the primaries of sRGB (ITU-R BT.709).
    double luminance = 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
    uint8_t code = encoder_encode(&pass->renderer->encoder, (float)luminance);
    return (float)code / ENCODING_CODE_MAXIMUM * dimming;
}

/** @return The largest difference of a primary, in steps of 8 bits. */
static float code_difference(const double a[3], const double b[3]) {
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

/** @return What a pixel's rays meet, as one number: the same where they meet the same. */
static uint32_t path_hash_of(const AovSample *sample) {
    /** Multiplier of a linear congruential generator (Knuth, MMIX). */
    const uint64_t multiplier = UINT64_C(6364136223846793005);
    uint64_t hash = (sample->lights_occluded + 1) * multiplier + sample->lights_tested;
    for (uint32_t i = 0; i < sample->secondary_count; i++) {
        hash = hash * multiplier + (uint64_t)(sample->secondary_shapes[i] + 2);
    }
    return (uint32_t)((hash * multiplier) >> 32);
}

/**
 * @return What is wrong with a pixel.
 * @param sample  What an engine says of it.
 */
static ShadingArtifact classify_artifact(const AovSample *sample, const AovSample *reference) {
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

/** Takes the numbers of a strip from a survey. @return How many were traced. */
static RayCounts strip_trace_aovs(const LayerPass *pass, const PixelGrid *strip) {
    const LayerRenderer *layer_renderer = pass->layer_renderer;
    AovSample samples[STRIP_RAYS];
    RayCounts counts = {0};
    pass->renderer->settings.engine->trace_aovs(
        pass->renderer->tracer, strip, layer_aov_mask(layer_renderer->layer), samples, &counts);
    for (int row = 0; row < strip->rows; row++) {
        for (int column = 0; column < strip->columns; column++) {
            float *values = layer_renderer->values +
                            LAYER_VALUES * layer_pass_cell_index(pass, strip, column, row);
            layer_values(layer_renderer->layer, &samples[row * strip->columns + column], values);
        }
    }
    return counts;
}

/** Asks both tracers about the paths of a strip. @return How many were traced, by the engine that
 *  is judged. */
static RayCounts strip_find_artifacts(const LayerPass *pass, const PixelGrid *strip) {
    const LayerRenderer *layer_renderer = pass->layer_renderer;
    AovSample samples[STRIP_RAYS], reference_samples[STRIP_RAYS];
    RayCounts counts = {0}, reference_counts = {0};
    pass->renderer->settings.engine->trace_aovs(pass->renderer->tracer, strip, AOV_RADIANCE,
                                                samples, &counts);
    layer_renderer->reference->trace_aovs(layer_renderer->reference_tracer, strip, AOV_RADIANCE,
                                          reference_samples, &reference_counts);
    for (int row = 0; row < strip->rows; row++) {
        for (int column = 0; column < strip->columns; column++) {
            size_t cell = layer_pass_cell_index(pass, strip, column, row),
                   i = (size_t)(row * strip->columns);
            float *values = layer_renderer->values + LAYER_VALUES * cell;
            i += (size_t)column;
            values[0] = perceived_brightness(pass, reference_samples[i].color);
            values[1] = (float)classify_artifact(&samples[i], &reference_samples[i]);
            layer_renderer->path_hashes[cell] = path_hash_of(&reference_samples[i]);
        }
    }
    return counts;
}

/** Asks both tracers about the colours of a strip; or only the one that is judged. @return How many
 *  were traced, by the engine that is judged. */
static RayCounts strip_measure_error(const LayerPass *pass, const PixelGrid *strip) {
    const LayerRenderer *layer_renderer = pass->layer_renderer;
    double colors[3 * STRIP_RAYS], reference_colors[3 * STRIP_RAYS];
    RayCounts counts = {0}, reference_counts = {0};
    size_t rays = (size_t)strip->columns * (size_t)strip->rows;
    pass->renderer->settings.engine->trace(pass->renderer->tracer, strip, colors, &counts);
    if (pass->uses_reference) {
        layer_renderer->reference->trace(layer_renderer->reference_tracer, strip, reference_colors,
                                         &reference_counts);
    }
    for (size_t i = 0; i < rays; i++) {
        int column = (int)(i % (size_t)strip->columns), row = (int)(i / (size_t)strip->columns);
        const double a[3] = {colors[i], colors[rays + i], colors[2 * rays + i]};
        const double b[3] = {reference_colors[i], reference_colors[rays + i],
                             reference_colors[2 * rays + i]};
        float *values =
            layer_renderer->values + LAYER_VALUES * layer_pass_cell_index(pass, strip, column, row);
        values[0] = pass->uses_reference ? code_difference(a, b) : NAN;
        values[1] = pass->uses_reference ? 0 : perceived_brightness(pass, a);
    }
    return counts;
}

/** Keeps the ends of a block's numbers. */
static void tile_update_range(const LayerPass *pass, const PixelGrid *grid, size_t index) {
    double *range = pass->layer_renderer->ranges + 2 * index;
    range[0] = HUGE_VAL;
    range[1] = -HUGE_VAL;
    for (int row = 0; row < grid->rows; row++) {
        for (int column = 0; column < grid->columns; column++) {
            size_t cell = layer_pass_cell_index(pass, grid, column, row);
            double value = (double)pass->layer_renderer->values[LAYER_VALUES * cell];
            range[0] = value < range[0] ? value : range[0];
            range[1] = value > range[1] ? value : range[1];
        }
    }
}

void layer_measure_tile(void *context, size_t index) {
    LayerPass *pass = context;
    Layer layer = pass->layer_renderer->layer;
    PixelGrid tile = tile_at(pass->width, pass->height, index);
    const PixelGrid grid = tile_subsample(&tile, pass->stride);
    int rows = pass->renderer->settings.engine->lanes > 1 ? STRIP_ROWS : 1;
    for (int row = 0; row < grid.rows && !layer_pass_is_stopped(pass); row += rows) {
        PixelGrid strip = grid;
        strip.y += row * grid.stride;
        strip.rows = grid.rows - row < rows ? grid.rows - row : rows;
        RayCounts counts = layer == LAYER_ACNE    ? strip_find_artifacts(pass, &strip)
                           : layer == LAYER_ERROR ? strip_measure_error(pass, &strip)
                                                  : strip_trace_aovs(pass, &strip);
        atomic_fetch_add_explicit(&pass->ray_count, ray_counts_sum(&counts), memory_order_relaxed);
    }
    tile_update_range(pass, &grid, index);
}

/* --- time ------------------------------------------------------------------------------------- */

/**
 * Takes the time of a few pixels.
 * @param group  The pixels, all of them.
 * @return Nanoseconds each.
 */
static float time_pixels(LayerPass *pass, const PixelGrid *group) {
    double colors[3 * STRIP_RAYS];
    RayCounts counts = {0};
    double start = clock_now_seconds();
    pass->renderer->settings.engine->trace(pass->renderer->tracer, group, colors, &counts);
    double seconds = clock_now_seconds() - start;
    atomic_fetch_add_explicit(&pass->ray_count, ray_counts_sum(&counts), memory_order_relaxed);
    return (float)(seconds * 1e9 / (group->columns * group->rows));
}

/** Notes the time of pixels: the shortest so far. */
static void cell_update_time(const LayerPass *pass, const PixelGrid *grid, float time) {
    for (int row = 0; row < grid->rows; row++) {
        for (int column = 0; column < grid->columns; column++) {
            size_t cell = layer_pass_cell_index(pass, grid, column, row);
            float *value = pass->layer_renderer->values + LAYER_VALUES * cell;
            *value = pass->repeat > 0 ? fminf(*value, time) : time;
        }
    }
}

/**
 * @return As many pixels of a block as an engine takes at once.
 * @param x  Which column of it comes first.
 */
static PixelGrid timing_group(const LayerPass *pass, const PixelGrid *tile, int x, int y) {
    int lanes = pass->renderer->settings.engine->lanes;
    int columns = lanes == 1 ? TIMING_GROUP_COLUMNS : lanes > STRIP_ROWS ? lanes : STRIP_ROWS;
    int rows = lanes == 1 ? TIMING_GROUP_ROWS : STRIP_ROWS;
    PixelGrid group = {.x = tile->x + x, .y = tile->y + y, .stride = 1};
    group.columns = tile->columns - x < columns ? tile->columns - x : columns;
    group.rows = tile->rows - y < rows ? tile->rows - y : rows;
    return group;
}

void layer_time_tile(void *context, size_t index) {
    LayerPass *pass = context;
    const PixelGrid tile = tile_at(pass->width, pass->height, index);
    const PixelGrid cells = tile_subsample(&tile, pass->stride);
    if (pass->repeat < 0) {
        const PixelGrid group = timing_group(pass, &tile, tile.columns / 2, tile.rows / 2);
        cell_update_time(pass, &cells, time_pixels(pass, &group));
    }
    const PixelGrid group_size = timing_group(pass, &tile, 0, 0);
    for (int y = 0; pass->repeat >= 0 && y < tile.rows; y += group_size.rows) {
        for (int x = 0; x < tile.columns && !layer_pass_is_stopped(pass); x += group_size.columns) {
            const PixelGrid group = timing_group(pass, &tile, x, y);
            cell_update_time(pass, &group, time_pixels(pass, &group));
        }
    }
    tile_update_range(pass, &cells, index);
}
