/**
 * @file
 * @brief Samples of a picture: rays that are spread over it, as many as there is time for.
 */
#include "render/renderer_internal.h"

/** Width and height of a block, rays. */
enum { BLOCK_SIZE = 8 };

/** Pixels from one ray of a forecast to the next, in both directions, at most. */
enum { FORECAST_STRIDE_MAXIMUM = 8 };

/** Rays of a forecast, at least, if the picture has as many: one camera ray in 200 that lacks light
 *  is then missed once in 150 forecasts. */
enum { FORECAST_RAYS_MINIMUM = 1000 };

typedef struct PictureSample PictureSample;

/** A sample of the picture, as its threads share it. */
struct PictureSample {
    const Renderer *renderer; /**< The renderer. */
    int stride;               /**< Pixels from one ray to the next, in both directions. */
    size_t count;             /**< Number of blocks of the picture. */
    size_t step;              /**< From a block to the next one in time, modulo #count. */
    double deadline;          /**< On #clock_now_seconds. */
    const atomic_bool *stop;  /**< Once true, no further block is traced; NULL: never. */
    RenderPass rays;          /**< Sums up the rays of a forecast. */
    atomic_size_t rays_done;  /**< Rays that were traced. */
    /** Traces the rays of some rows of a block. */
    void (*trace)(PictureSample *sample, const PixelGrid *rows);
};

/** @return Rays along a row or a column. @param pixels Pixels of it. */
static int rays_along(int pixels, int stride) {
    return (pixels + stride - 1) / stride;
}

/** @return The stride of a forecast. */
static int forecast_stride(const RenderSettings *settings) {
    int stride = FORECAST_STRIDE_MAXIMUM;
    while (stride > 1 &&
           rays_along(settings->width, stride) * rays_along(settings->height, stride) <
               FORECAST_RAYS_MINIMUM) {
        stride /= 2;
    }
    return stride;
}

/** @return Blocks of a row or a column. @param pixels Pixels of it. */
static size_t blocks_along(int pixels, int stride) {
    return ((size_t)rays_along(pixels, stride) + BLOCK_SIZE - 1) / BLOCK_SIZE;
}

/** @return The rays of a block. @param index Of the block in time. */
static PixelGrid block_grid(const PictureSample *sample, size_t index) {
    const RenderSettings *settings = &sample->renderer->settings;
    int stride = sample->stride;
    size_t block = index * sample->step % sample->count;
    size_t across = blocks_along(settings->width, stride);
    int column = (int)(block % across) * BLOCK_SIZE, row = (int)(block / across) * BLOCK_SIZE;
    int columns = rays_along(settings->width, stride) - column;
    int rows = rays_along(settings->height, stride) - row;
    return (PixelGrid){.x = column * stride + stride / 2,
                       .y = row * stride + stride / 2,
                       .columns = columns < BLOCK_SIZE ? columns : BLOCK_SIZE,
                       .rows = rows < BLOCK_SIZE ? rows : BLOCK_SIZE,
                       .stride = stride};
}

/** @return Whether there is no time left for a further block. */
static bool sample_is_over(const PictureSample *sample) {
    return clock_now_seconds() > sample->deadline ||
           (sample->stop && atomic_load_explicit(sample->stop, memory_order_relaxed));
}

/** Finds the nearest hits of camera rays. See #PictureSample.trace. */
static void sample_hits(PictureSample *sample, const PixelGrid *rows) {
    const Renderer *renderer = sample->renderer;
    int shapes[BLOCK_SIZE * BLOCK_SIZE];
    double distances[BLOCK_SIZE * BLOCK_SIZE];
    renderer->settings.engine->trace_primary(renderer->tracer, rows, shapes, distances);
    atomic_fetch_add(&sample->rays_done, (size_t)rows->columns * (size_t)rows->rows);
}

/** Traces camera rays with all that come from them. See #PictureSample.trace. */
static void sample_light(PictureSample *sample, const PixelGrid *rows) {
    const Renderer *renderer = sample->renderer;
    double rgb[3 * BLOCK_SIZE * BLOCK_SIZE];
    RayCounts counts = {0};
    renderer->settings.engine->trace(renderer->tracer, rows, rgb, &counts);
    render_pass_add_rays(&sample->rays, &counts, 0);
}

/**
 * Traces a block, as long as there is time. See #ThreadPoolTask. Between two looks at the clock, an
 * engine traces as many rows as it has lanes: a ray may take milliseconds in quad.
 */
static void sample_block(void *context, size_t index) {
    PictureSample *sample = context;
    PixelGrid block = block_grid(sample, index), rows = block;
    int lanes = sample->renderer->settings.engine->lanes;
    for (int done = 0; done < block.rows && !sample_is_over(sample); done += rows.rows) {
        rows.y = block.y + done * block.stride;
        rows.rows = lanes < block.rows - done ? lanes : block.rows - done;
        sample->trace(sample, &rows);
    }
}

/**
 * @return A step through blocks that visits each once and spreads any number of them evenly: near
 *         the golden ratio of their number, and without a common divisor with it (Weyl's sequence).
 * @param count  Number of blocks, at least 1.
 */
static size_t spreading_step(size_t count) {
    size_t step = (size_t)(0.6180339887498949 * (double)count);
    for (;; step++) {
        size_t a = count, b = step;
        while (b != 0) {
            size_t rest = a % b;
            a = b;
            b = rest;
        }
        if (a == 1) {
            return step;
        }
    }
}

/** Traces blocks until all are traced or the time is over. */
static void sample_run(Renderer *renderer, PictureSample *sample) {
    const RenderSettings *settings = &renderer->settings;
    sample->renderer = renderer;
    sample->count = blocks_along(settings->width, sample->stride) *
                    blocks_along(settings->height, sample->stride);
    sample->step = spreading_step(sample->count);
    thread_pool_run(renderer->thread_pool, sample->count, sample_block, sample);
}

RenderStats renderer_sample_camera_rays(Renderer *renderer, double seconds) {
    const RenderSettings *settings = &renderer->settings;
    size_t pixels = (size_t)settings->width * (size_t)settings->height;
    double start = clock_now_seconds();
    PictureSample sample = {.stride = 1, .deadline = start + seconds, .trace = sample_hits};
    sample_run(renderer, &sample);
    size_t rays_done = atomic_load(&sample.rays_done);
    return (RenderStats){.seconds = clock_now_seconds() - start,
                         .rays = {.camera = rays_done},
                         .progress = (double)rays_done / (double)pixels,
                         .is_finished = rays_done == pixels};
}

RayCounts renderer_forecast_light(Renderer *renderer, double seconds, const atomic_bool *stop) {
    if (!(renderer_contents(renderer).radiance_bound > 0)) {
        return (RayCounts){0};
    }
    PictureSample sample = {.stride = forecast_stride(&renderer->settings),
                            .deadline = clock_now_seconds() + seconds,
                            .stop = stop,
                            .trace = sample_light,
                            .rays = {.renderer = renderer}};
    sample_run(renderer, &sample);
    return render_pass_stats(&sample.rays, false).rays;
}
