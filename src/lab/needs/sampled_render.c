/**
 * @file
 * @brief Chooses pixels and renders them.
 */
#include "lab/needs/sampled_render.h"

#include "base/clock.h"
#include "render/render_pass.h"
#include "render/thread_pool.h"

#include <stdlib.h>
#include <string.h>

/* --- which pixels -------------------------------------------------------------------------------
 */

/** Fewest pixels that are sampled, as far as a picture has so many: those of 320 x 240. Fewer
 * hardly meet the edges and black points that they are to find. */
enum { SAMPLED_MINIMUM = 1200 };

bool pixel_is_any(const void *context, int x, int y) {
    (void)context;
    (void)x;
    (void)y;
    return true;
}

int sampling_cell_of(int width, int height) {
    int cell = SAMPLING_CELL_MAXIMUM;
    while (cell > 1 && (int64_t)width * height < (int64_t)SAMPLED_MINIMUM * cell * cell) {
        cell /= 2;
    }
    return cell;
}

bool pixel_is_sampled(const void *context, int x, int y) {
    const unsigned cell = (unsigned)*(const int *)context;
    const unsigned column = (unsigned)x / cell, row = (unsigned)y / cell;
    uint64_t z = ((uint64_t)row << 32 | column) + 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    z ^= z >> 31;
    return (unsigned)x % cell == z % cell && (unsigned)y % cell == z / cell % cell;
}

/** Adds the pixels of a tile. */
static void add_tile_pixels(PixelSet *pixels, size_t tile, PixelTest test, const void *context) {
    PixelGrid grid = tile_at(pixels->width, pixels->height, tile);
    pixels->tile_first[tile] = pixels->count;
    for (int index = 0; index < grid.rows * grid.columns; index++) {
        if (test(context, grid.x + index % grid.columns, grid.y + index / grid.columns)) {
            pixels->chosen[pixels->count++] = (uint16_t)index;
        }
    }
    pixels->tile_first[tile + 1] = pixels->count;
}

bool pixel_set_init(PixelSet *pixels, int width, int height, PixelTest test, const void *context,
                    Error *error) {
    size_t all = (size_t)width * (size_t)height;
    *pixels = (PixelSet){.width = width, .height = height, .tile_count = tile_count(width, height)};
    pixels->tile_first = calloc(pixels->tile_count + 1, sizeof *pixels->tile_first);
    pixels->chosen = malloc(all * sizeof *pixels->chosen);
    if (!pixels->tile_first || !pixels->chosen) {
        pixel_set_deinit(pixels);
        return error_set(error, STATUS_FAILED, "no memory for %zu pixels", all);
    }
    for (size_t tile = 0; tile < pixels->tile_count; tile++) {
        add_tile_pixels(pixels, tile, test, context);
    }
    return true;
}

void pixel_set_deinit(PixelSet *pixels) {
    free(pixels->tile_first);
    free(pixels->chosen);
    *pixels = (PixelSet){0};
}

PixelGrid pixel_set_tile_grid(const PixelSet *pixels, size_t tile) {
    PixelGrid grid = tile_at(pixels->width, pixels->height, tile);
    grid.selected = pixels->chosen + pixels->tile_first[tile];
    grid.selected_count = pixels->tile_first[tile + 1] - pixels->tile_first[tile];
    return grid;
}

/* --- rendered how -------------------------------------------------------------------------------
 */

/** Most rays of a tile, per sample. */
enum { RAYS_PER_TILE = TILE_COLUMNS * TILE_ROWS };

/** A render in progress, shared by its threads. */
typedef struct SampleJob {
    const RenderContext *context; /**< What is rendered. */
    const Variant *variant;       /**< How it is rendered. */
    const Tracer *tracer;         /**< The variant's tracer. */
    SampledRender *render;        /**< The result. */
    RayCounts *counts;            /**< Rays traced, per tile. */
} SampleJob;

/** @return Whether rendering was stopped. @param context A #RenderContext. */
static bool context_is_stopped(const void *context) {
    const RenderContext *render_context = context;
    return render_context->stop && atomic_load_explicit(render_context->stop, memory_order_relaxed);
}

/** Traces one sample of a tile's pixels. @param first Pixels of the set before the tile. */
static void trace_sample(const SampleJob *job, PixelGrid *grid, size_t first, RayCounts *counts) {
    double planes[3 * RAYS_PER_TILE];
    size_t count = grid->selected_count;
    size_t index = (size_t)grid->sample * job->context->pixels->count + first;
    grid->path_hashes = job->render->path_hashes + index;
    job->variant->engine->trace(job->tracer, grid, planes, counts);
    for (size_t i = 0; i < 3 * count; i++) {
        job->render->rgb[3 * (index + i % count) + i / count] = planes[i];
    }
}

/** Is a #ThreadPoolTask: traces a tile. */
static void render_tile(void *context, size_t index) {
    const SampleJob *job = context;
    PixelGrid grid = pixel_set_tile_grid(job->context->pixels, index);
    grid.is_stopped = context_is_stopped;
    grid.stop_context = job->context;
    for (int sample = 0; grid.selected_count > 0 && sample < job->variant->samples_traced;
         sample++) {
        if (context_is_stopped(job->context)) {
            return;
        }
        grid.sample = sample;
        trace_sample(job, &grid, job->context->pixels->tile_first[index], &job->counts[index]);
    }
}

/** Traces all tiles. @return false if anything is wrong. */
static bool render_tiles(SampleJob *job, ThreadPool *workers, Error *error) {
    const RenderContext *render_context = job->context;
    const Engine *engine = job->variant->engine;
    const PixelSet *pixels = render_context->pixels;
    Tracer *tracer = engine->create_tracer(render_context->scene, &job->variant->trace, error);
    if (!tracer) {
        return false;
    }
    engine->set_view(tracer, render_context->scene, pixels->width, pixels->height);
    job->tracer = tracer;
    double start = clock_process_cpu_seconds();
    thread_pool_run(workers, pixels->tile_count, render_tile, job);
    job->render->cpu_seconds = clock_process_cpu_seconds() - start;
    engine->destroy(tracer);
    return !context_is_stopped(render_context) ||
           error_set(error, STATUS_INTERRUPTED, "interrupted");
}

/** @return The rays of all tiles. */
static RayCounts sum_counts(const RayCounts *counts, size_t tiles) {
    RayCounts sum = {0};
    for (size_t i = 0; i < tiles; i++) {
        sum.camera += counts[i].camera;
        sum.reflection += counts[i].reflection;
        sum.refraction += counts[i].refraction;
        sum.shadow += counts[i].shadow;
        sum.total_reflection += counts[i].total_reflection;
    }
    return sum;
}

bool render_samples(const RenderContext *render_context, const Variant *variant,
                    SampledRender *render, Error *error) {
    const PixelSet *pixels = render_context->pixels;
    *render = (SampledRender){.ray_count = pixels->count * (size_t)variant->samples_traced};
    render->rgb = calloc(3 * render->ray_count + 1, sizeof *render->rgb);
    render->path_hashes = calloc(render->ray_count + 1, sizeof *render->path_hashes);
    SampleJob job = {.context = render_context, .variant = variant, .render = render};
    job.counts = calloc(pixels->tile_count, sizeof *job.counts);
    bool has_room = render->rgb && render->path_hashes && job.counts;
    ThreadPool *workers = has_room ? thread_pool_create(render_context->threads, error) : NULL;
    bool is_taken = workers && render_tiles(&job, workers, error);
    if (is_taken) {
        render->ray_counts = sum_counts(job.counts, pixels->tile_count);
    } else {
        if (!has_room) {
            error_set(error, STATUS_FAILED, "no memory for %zu rays", render->ray_count);
        }
        sampled_render_deinit(render);
    }
    thread_pool_destroy(workers);
    free(job.counts);
    return is_taken;
}

void sampled_render_deinit(SampledRender *render) {
    free(render->rgb);
    free(render->path_hashes);
    *render = (SampledRender){0};
}
