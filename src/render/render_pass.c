/**
 * @file
 * @brief Passes and tiles: the pipeline of all pictures.
 */
#include "render/render_pass.h"

#include "render/layer_renderer.h"

/* --- tiles ------------------------------------------------------------------------------------ */

/** @return Tiles per row. @param width Pixels of the picture. */
static size_t tiles_across(int width) {
    return ((size_t)width + TILE_COLUMNS - 1) / TILE_COLUMNS;
}

size_t tile_count(int width, int height) {
    return tiles_across(width) * (((size_t)height + TILE_ROWS - 1) / TILE_ROWS);
}

PixelGrid tile_at(int width, int height, size_t index) {
    int x = (int)(index % tiles_across(width)) * TILE_COLUMNS;
    int y = (int)(index / tiles_across(width)) * TILE_ROWS;
    int columns = width - x < TILE_COLUMNS ? width - x : TILE_COLUMNS;
    int rows = height - y < TILE_ROWS ? height - y : TILE_ROWS;
    return (PixelGrid){.x = x, .y = y, .columns = columns, .rows = rows, .stride = 1};
}

PixelGrid tile_subsample(const PixelGrid *tile, int stride) {
    PixelGrid grid = *tile;
    grid.x += stride / 2;
    grid.y += stride / 2;
    grid.columns = (tile->columns + stride - 1) / stride;
    grid.rows = (tile->rows + stride - 1) / stride;
    grid.stride = stride;
    return grid;
}

/* --- passes ----------------------------------------------------------------------------------- */

bool pass_range_next(PassRange *range, int samples, bool has_preview) {
    if (range->stride == 0) {
        *range = (PassRange){.stride = COARSEST_STRIDE, .is_preview = has_preview};
    } else if (range->is_preview) {
        range->is_preview = false;
    } else if (range->stride > 1) {
        range->stride /= 2;
    } else {
        range->first_sample = ++range->last_sample;
    }
    return range->last_sample < samples;
}

size_t pass_range_total_rays(int width, int height, int samples, bool has_preview) {
    size_t rays = 0;
    PassRange range = {0};
    while (pass_range_next(&range, samples, has_preview)) {
        size_t across = ((size_t)width + (size_t)range.stride - 1) / (size_t)range.stride;
        size_t down = ((size_t)height + (size_t)range.stride - 1) / (size_t)range.stride;
        rays += across * down;
    }
    return rays;
}

bool render_pass_is_stopped(const RenderPass *pass) {
    return render_pass_has_stop(pass);
}

/** @return A position from the middle outwards. @param index 0 to count - 1, which gives each
 *  position once. */
static size_t from_middle(size_t index, size_t count) {
    size_t middle = (count - 1) / 2, away = (index + 1) / 2;
    return index % 2 ? middle + away : middle - away;
}

/** @return The number of the tile that comes at an index, from the middle row outwards, and in each
 *  row from its middle. */
static size_t tile_from_middle(const RenderPass *pass, size_t index) {
    size_t across = tiles_across(pass->width),
           down = tile_count(pass->width, pass->height) / across;
    return from_middle(index / across, down) * across + from_middle(index % across, across);
}

/** All tiles of a pass, as the thread pool sees them. */
typedef struct PassTiles {
    RenderPass *pass; /**< The pass. */
    ShadeTile shade;  /**< Shades a tile. */
} PassTiles;

/** Shades a tile, unless the pass is stopped. See #ThreadPoolTask. */
static void shade_pass_tile(void *context, size_t index) {
    const PassTiles *tiles = context;
    RenderPass *pass = tiles->pass;
    if (render_pass_is_stopped(pass)) {
        return;
    }
    size_t number = pass->on_tile ? tile_from_middle(pass, index) : index;
    PixelGrid tile = tile_at(pass->width, pass->height, number);
    tiles->shade(pass, &tile, number);
    atomic_fetch_add_explicit(&pass->renderer->tiles_done, 1, memory_order_relaxed);
    // A tile that was stopped is not in the picture.
    if (pass->on_tile && !render_pass_is_stopped(pass)) {
        pass->on_tile(pass, number);
    }
}

bool render_pass_run_tiles(RenderPass *pass, ShadeTile shade) {
    PassTiles tiles = {pass, shade};
    size_t count = tile_count(pass->width, pass->height);
    atomic_store(&pass->renderer->tiles_done, 0);
    atomic_store(&pass->renderer->tiles_total, count);
    atomic_store(&pass->renderer->pass_start, clock_now_seconds());
    thread_pool_run(pass->renderer->thread_pool, count, shade_pass_tile, &tiles);
    return !render_pass_is_stopped(pass);
}

/** Adds to a counter. Most counts of most tiles are 0, and an atomic addition of 0 costs as much as
 * any where other threads count, too. */
static void add_count(_Atomic uint64_t *counter, uint64_t count) {
    if (count > 0) {
        atomic_fetch_add_explicit(counter, count, memory_order_relaxed);
    }
}

void render_pass_add_rays(RenderPass *pass, const RayCounts *counts, size_t rays) {
    add_count(&pass->camera, counts->camera);
    add_count(&pass->reflected, counts->reflection);
    add_count(&pass->refracted, counts->refraction);
    add_count(&pass->total_reflections, counts->total_reflection);
    add_count(&pass->shadow, counts->shadow);
    add_count(&pass->unresolved, counts->unresolved);
    double steps = atomic_load(&pass->unresolved_steps);
    while (
        counts->unresolved_steps > steps &&
        !atomic_compare_exchange_weak(&pass->unresolved_steps, &steps, counts->unresolved_steps)) {
    }
    if (rays > 0) {
        atomic_fetch_add_explicit(&pass->renderer->rays_done, rays, memory_order_relaxed);
    }
}

RenderStats render_pass_stats(RenderPass *pass, bool is_last) {
    double seconds = clock_now_seconds() - pass->start;
    if (pass->range.stride == 1 && pass->full_resolution_seconds == 0) {
        pass->full_resolution_seconds = seconds;
    }
    uint64_t measured = pass->range.is_preview ? 0 : atomic_load(&pass->pixel_count);
    const Engine *reference = layer_class(pass->layer)->reference != REFERENCE_NONE
                                  ? pass->renderer->layer_renderer.reference
                                  : NULL;
    return (RenderStats){
        .seconds = seconds,
        .full_resolution_seconds = pass->full_resolution_seconds,
        .rays = {.camera = atomic_load(&pass->camera),
                 .reflection = atomic_load(&pass->reflected),
                 .refraction = atomic_load(&pass->refracted),
                 .total_reflection = atomic_load(&pass->total_reflections),
                 .shadow = atomic_load(&pass->shadow),
                 .unresolved = atomic_load(&pass->unresolved),
                 .unresolved_steps = atomic_load(&pass->unresolved_steps)},
        .stride = pass->range.stride,
        .samples = pass->layer == LAYER_SHADED ? pass->range.last_sample + 1 : 1,
        .progress = renderer_progress(pass->renderer),
        .is_finished = is_last,
        .layer = {.layer = pass->layer,
                  .scale = pass->scale,
                  .pixel_count = atomic_load(&pass->pixel_count),
                  .artifact_pixels = atomic_load(&pass->artifact_pixels),
                  .leak_pixels = atomic_load(&pass->leak_pixels),
                  .measured_fraction = (double)measured / ((double)pass->width * pass->height),
                  .reference = reference ? reference->name : NULL}};
}
