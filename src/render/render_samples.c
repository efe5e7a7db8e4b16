/**
 * @file
 * @brief The shaded picture: samples of pixels, summed, and encoded tile by tile.
 */
#include "render/renderer_internal.h"
#include "render/row_encoder.h"

#include <string.h>

/** Pixels of a tile. */
#define TILE_PIXELS (TILE_COLUMNS * TILE_ROWS)

/** Numbers of a tile: three channels per pixel. */
#define TILE_VALUES (TILE_PIXELS * 3)

/** A tile of a pass on the thread that traces it. */
typedef struct TileJob {
    PixelGrid tile;               /**< Its pixels. */
    PixelGrid grid;               /**< Its rays. */
    double sums[TILE_VALUES];     /**< Sum of the samples, plane by plane. */
    double minima[TILE_VALUES];   /**< Least of this pass's samples; adaptive sampling only. */
    double maxima[TILE_VALUES];   /**< Greatest of them. */
    uint32_t counts[TILE_PIXELS]; /**< Samples per pixel. */
    RayCounts ray_counts;         /**< The rays traced. */
} TileJob;

/** Copies the sums of a tile from or to the accumulator, plane by plane. @param is_load true: from
 *  it; false: to it. */
static void tile_copy_sums(SampleAccumulator *accumulator, TileJob *job, bool is_load) {
    const PixelGrid *tile = &job->tile;
    size_t pixels = (size_t)accumulator->width * (size_t)accumulator->height;
    size_t columns = (size_t)tile->columns;
    double *tile_row = job->sums;
    for (size_t row = 0; row < 3 * (size_t)tile->rows; row++, tile_row += columns) {
        size_t plane = row / (size_t)tile->rows, y = row % (size_t)tile->rows + (size_t)tile->y;
        double *picture_row =
            accumulator->sums + plane * pixels + y * (size_t)accumulator->width + (size_t)tile->x;
        memcpy(is_load ? tile_row : picture_row, is_load ? picture_row : tile_row,
               columns * sizeof *tile_row);
    }
}

/** @return Index of the first pixel of a tile's row in the whole picture. */
static size_t row_pixel_index(const RenderPass *pass, const PixelGrid *tile, int row) {
    return (size_t)(tile->y + row) * (size_t)pass->width + (size_t)tile->x;
}

/** @return Whether the pass belongs to adaptive sampling. */
static bool render_pass_is_adaptive(const RenderPass *pass) {
    return pass->accumulator && pass->accumulator->counts;
}

/** Loads the sums and counts of a tile before a pass. */
static void tile_load(const RenderPass *pass, TileJob *job) {
    const PixelGrid *tile = &job->tile;
    size_t columns = (size_t)tile->columns;
    if (pass->range.first_sample > 0) {
        tile_copy_sums(pass->accumulator, job, true);
    }
    for (int row = 0;
         pass->range.first_sample > 0 && render_pass_is_adaptive(pass) && row < tile->rows; row++) {
        memcpy(job->counts + (size_t)row * columns,
               pass->accumulator->counts + row_pixel_index(pass, tile, row),
               columns * sizeof *job->counts);
    }
}

/**
 * Extends the range of one channel of a pixel.
 * @param index  Index of the channel in the accumulator.
 * @param minimum  Least of a pass's samples.
 * @param is_first  Whether it has no range yet.
 */
static void range_extend(const RenderPass *pass, size_t index, double minimum, double maximum,
                         bool is_first) {
    uint16_t *stored_minimum = &pass->accumulator->minima[index],
             *stored_maximum = &pass->accumulator->maxima[index];
    bool beyond_white = pass->picture && pass->picture->linear;
    uint16_t minimum_code = adaptive_code(pass->adaptive_encoder, (float)minimum, beyond_white);
    uint16_t maximum_code =
        minimum < maximum ? adaptive_code(pass->adaptive_encoder, (float)maximum, beyond_white)
                          : minimum_code;
    *stored_minimum = is_first || minimum_code < *stored_minimum ? minimum_code : *stored_minimum;
    *stored_maximum = is_first || maximum_code > *stored_maximum ? maximum_code : *stored_maximum;
}

/** Saves the counts and ranges of a row of a tile. */
static void tile_save_row(const RenderPass *pass, const TileJob *job, int row) {
    SampleAccumulator *accumulator = pass->accumulator;
    size_t columns = (size_t)job->tile.columns, plane = columns * (size_t)job->tile.rows;
    size_t pixel = row_pixel_index(pass, &job->tile, row), job_pixel = (size_t)row * columns;
    bool is_first = pass->range.first_sample == 0;
    for (size_t end = job_pixel + columns; job_pixel < end; job_pixel++, pixel++) {
        if (!is_first && accumulator->counts[pixel] == job->counts[job_pixel]) {
            continue;
        }
        accumulator->counts[pixel] = job->counts[job_pixel];
        for (size_t channel = 0; channel < 3; channel++) {
            size_t value_index = channel * plane + job_pixel;
            range_extend(pass, 3 * pixel + channel, job->minima[value_index],
                         job->maxima[value_index], is_first);
        }
    }
}

/** Saves the sums, counts and ranges of a tile after a pass. */
static void tile_save(const RenderPass *pass, TileJob *job) {
    tile_copy_sums(pass->accumulator, job, false);
    for (int row = 0; render_pass_is_adaptive(pass) && row < job->tile.rows; row++) {
        tile_save_row(pass, job, row);
    }
}

/**
 * Averages a row of rays to linear light.
 * @param sums  Sums of the samples: the reds of the row.
 * @param plane  Distance from the reds to the greens, and to the blues.
 */
static void average_row_linear(const double *sums, size_t plane, const uint32_t *counts,
                               int columns, float *rgb) {
    for (size_t i = 0; i < 3 * (size_t)columns; i++) {
        rgb[i] = (float)(sums[i % 3 * plane + i / 3] * (1.0 / counts[i / 3]));
    }
}

/** Writes a tile into the picture: the colour of each ray fills its cell. */
static void tile_encode(const RenderPass *pass, const TileJob *job) {
    uint8_t row_colors[3 * TILE_COLUMNS];
    const PixelGrid *tile = &job->tile, *grid = &job->grid;
    size_t plane = (size_t)grid->columns * (size_t)grid->rows;
    for (int row = 0; row < tile->rows; row++) {
        size_t pixel = row_pixel_index(pass, tile, row);
        uint8_t *pixels = pass->picture->pixels + 3 * pixel;
        size_t first_ray = (size_t)(row / grid->stride) * (size_t)grid->columns;
        const double *sums = job->sums + first_ray;
        const uint32_t *counts = job->counts + first_ray;
        bool is_full_resolution = grid->stride == 1;
        if (is_full_resolution && pass->picture->linear) {
            average_row_linear(sums, plane, counts, grid->columns,
                               pass->picture->linear + 3 * pixel);
        }
        const SampleRow rays = {sums, plane, counts, grid->columns};
        row_encode(pass->encoder, &rays, is_full_resolution ? pixels : row_colors);
        for (int column = 0; !is_full_resolution && column < tile->columns; column++) {
            memcpy(pixels + 3 * column, row_colors + 3 * (column / grid->stride), 3);
        }
    }
}

/** @return The smaller. */
static inline double min_double(double a, double b) {
    return a < b ? a : b;
}

/** @return The larger. */
static inline double max_double(double a, double b) {
    return a > b ? a : b;
}

/**
 * Adds a sample of all rays to the sums and ranges. Sample 0 is in the sums already.
 * @param is_first  Whether it is the first of the pass.
 * @param is_adaptive  Whether there are ranges.
 */
static void tile_add_sample(TileJob *job, const double *colors, bool is_first, bool is_adaptive) {
    size_t value_count = 3 * (size_t)job->grid.columns * (size_t)job->grid.rows;
    for (size_t i = 0; job->grid.sample > 0 && i < value_count; i++) {
        job->sums[i] += colors[i];
    }
    if (is_adaptive && is_first) {
        memcpy(job->minima, colors, value_count * sizeof *colors);
        memcpy(job->maxima, colors, value_count * sizeof *colors);
    }
    for (size_t i = 0; is_adaptive && !is_first && i < value_count; i++) {
        job->minima[i] = min_double(job->minima[i], colors[i]);
        job->maxima[i] = max_double(job->maxima[i], colors[i]);
    }
}

/** @return Whether a pass is to stop. See #PixelGrid.is_stopped. */
static bool is_pass_stopped(const void *pass) {
    return render_pass_has_stop(pass);
}

/** Traces a sample of the rays of a tile. @return false when it was stopped. */
static bool tile_trace_sample(const RenderPass *pass, TileJob *job, int sample, double *colors) {
    if (render_pass_is_stopped(pass)) {
        return false;
    }
    job->grid.sample = sample;
    job->grid.is_stopped = is_pass_stopped;
    job->grid.stop_context = pass;
    pass->engine->trace(pass->tracer, &job->grid, colors, &job->ray_counts);
    return !render_pass_is_stopped(pass);
}

/** Traces the samples of a pass for all rays of a tile. @return false when it was stopped. */
static bool tile_trace_samples(const RenderPass *pass, TileJob *job) {
    double colors[TILE_VALUES];
    size_t rays = (size_t)job->grid.columns * (size_t)job->grid.rows;
    bool is_adaptive = render_pass_is_adaptive(pass) && pass->range.stride == 1;
    for (int sample = pass->range.first_sample; sample <= pass->range.last_sample; sample++) {
        double *target = sample == 0 ? job->sums : colors; // Sample 0 begins the sum.
        if (!tile_trace_sample(pass, job, sample, target)) {
            return false;
        }
        tile_add_sample(job, target, sample == pass->range.first_sample, is_adaptive);
        atomic_fetch_add_explicit(&pass->renderer->rays_done, rays, memory_order_relaxed);
    }
    for (size_t i = 0; i < rays; i++) {
        job->counts[i] = (uint32_t)pass->range.last_sample + 1;
    }
    return true;
}

/**
 * @return Number of active pixels that lack a sample.
 * @param[out] selected  Those pixels.
 */
static size_t select_missing_sample(const uint16_t *active, size_t count, const uint32_t *counts,
                                    int sample, uint16_t *selected) {
    size_t selected_count = 0;
    for (size_t i = 0; i < count; i++) {
        if (counts[active[i]] == (uint32_t)sample) {
            selected[selected_count++] = active[i];
        }
    }
    return selected_count;
}

/**
 * Adds a sample of selected pixels to the sums and ranges.
 * @param[in,out] job  The tile, with the selection in its grid.
 * @param[in,out] is_new  For each pixel, whether it has no sample of this pass yet.
 */
static void tile_add_selected_sample(TileJob *job, const double *colors, bool *is_new) {
    const PixelGrid *grid = &job->grid;
    size_t plane = (size_t)grid->columns * (size_t)grid->rows;
    for (size_t i = 0; i < grid->selected_count; i++) {
        size_t pixel = grid->selected[i];
        for (size_t channel = 0; channel < 3; channel++) {
            size_t index = channel * plane + pixel;
            double color = colors[channel * grid->selected_count + i];
            job->sums[index] += color;
            job->minima[index] = is_new[pixel] ? color : min_double(job->minima[index], color);
            job->maxima[index] = is_new[pixel] ? color : max_double(job->maxima[index], color);
        }
        is_new[pixel] = false;
        job->counts[pixel]++;
    }
}

/** Traces the samples that the active pixels of a tile lack. @return false when it was stopped. */
static bool tile_trace_active(const RenderPass *pass, TileJob *job, const uint16_t *active,
                              size_t active_count) {
    double colors[TILE_VALUES];
    uint16_t selected[TILE_PIXELS];
    bool is_new[TILE_PIXELS];
    memset(is_new, true, sizeof is_new);
    for (int sample = adaptive_first_samples(pass->samples);
         active_count > 0 && sample <= pass->range.last_sample; sample++) {
        size_t count = select_missing_sample(active, active_count, job->counts, sample, selected);
        if (count > 0) {
            job->grid.selected = selected;
            job->grid.selected_count = count;
            if (!tile_trace_sample(pass, job, sample, colors)) {
                return false;
            }
            tile_add_selected_sample(job, colors, is_new);
            atomic_fetch_add_explicit(&pass->renderer->rays_done, count, memory_order_relaxed);
        }
    }
    return true;
}

/** Finishes a tile: saves its samples and writes its pixels. */
static void tile_finish(RenderPass *pass, TileJob *job) {
    if (pass->accumulator && pass->range.stride == 1) {
        tile_save(pass, job);
    }
    if (pass->picture) {
        tile_encode(pass, job);
    }
    render_pass_add_rays(pass, &job->ray_counts, 0); // Progress has been counted by sample.
}

/** Traces all pixels of a tile. See #ShadeTile. */
static void shade_tile(RenderPass *pass, const PixelGrid *tile, size_t index) {
    (void)index;
    TileJob job;
    job.tile = *tile;
    job.grid = tile_subsample(tile, pass->range.stride);
    job.ray_counts = (RayCounts){0};
    tile_load(pass, &job);
    if (tile_trace_samples(pass, &job)) {
        tile_finish(pass, &job);
    }
}

/** Traces the active pixels of a tile. See #ShadeTile. */
static void shade_tile_active(RenderPass *pass, const PixelGrid *tile, size_t index) {
    (void)index;
    TileJob job;
    uint16_t active[TILE_PIXELS];
    job.tile = job.grid = *tile;
    job.ray_counts = (RayCounts){0};
    size_t active_count = sample_accumulator_list_active(pass->accumulator, tile, active);
    if (active_count == 0 && pass->has_previous) {
        return;
    }
    tile_load(pass, &job);
    if (tile_trace_active(pass, &job, active, active_count)) {
        tile_finish(pass, &job);
    }
}

bool render_pass_run_samples(RenderPass *pass) {
    Renderer *renderer = pass->renderer;
    bool is_active_only = render_pass_is_adaptive(pass) &&
                          pass->range.first_sample >= adaptive_first_samples(pass->samples);
    if (is_active_only && adaptive_is_update_due(pass->range.first_sample)) {
        size_t remaining = sample_accumulator_update_active(pass->accumulator,
                                                            renderer->thread_pool, pass->samples);
        atomic_store(&renderer->rays_total, atomic_load(&renderer->rays_done) + remaining);
    }
    return render_pass_run_tiles(pass, is_active_only ? shade_tile_active : shade_tile);
}
