/**
 * @file
 * @brief Rendering in the background: passes coarse to fine, double-buffered, restarted at will.
 */
#include "render/ray_stack.h"
#include "render/renderer_internal.h"

#include <stdlib.h>
#include <string.h>

/** Seconds from the start until tiles of the first pass are shown, and between such pictures: a
 *  pass that is shorter is shown at once. */
static const double PART_INTERVAL = 0.04;

void background_renderer_init(BackgroundRenderer *background) {
    pthread_mutex_init(&background->mutex, NULL);
    pthread_cond_init(&background->wake, NULL);
    pthread_cond_init(&background->idle, NULL);
}

/** Makes a finished pass, in the back picture, the one that is shown. */
static void background_renderer_publish(Renderer *renderer, const RenderStats *stats) {
    BackgroundRenderer *background = &renderer->background;
    pthread_mutex_lock(&background->mutex);
    Picture shown = background->back;
    background->back = background->front;
    background->front = shown;
    background->has_front = true;
    background->stats = *stats;
    layer_renderer_publish(renderer, background->width, background->height);
    RenderPassCallback callback = background->callback;
    void *context = background->context;
    pthread_mutex_unlock(&background->mutex);
    if (callback) {
        callback(context);
    }
}

/** Shows the tiles of the first pass that are done. */
static void background_renderer_publish_part(RenderPass *pass) {
    BackgroundRenderer *background = &pass->renderer->background;
    RenderStats stats = render_pass_stats(pass, false);
    stats.is_part = true;
    pthread_mutex_lock(&background->mutex);
    background->has_part = true;
    background->stats = stats;
    RenderPassCallback callback = background->callback;
    void *context = background->context;
    pthread_mutex_unlock(&background->mutex);
    if (callback) {
        callback(context);
    }
}

/** Notes a tile of the first pass, and shows what is there from time to time. See
 *  #RenderPass.on_tile. */
static void background_renderer_on_tile(RenderPass *pass, size_t index) {
    BackgroundRenderer *background = &pass->renderer->background;
    double now = clock_now_seconds(), due = atomic_load(&background->next_part_time);
    atomic_store_explicit(&background->tiles[index], true, memory_order_release);
    if (now >= due &&
        atomic_compare_exchange_strong(&background->next_part_time, &due, now + PART_INTERVAL)) {
        background_renderer_publish_part(pass);
    }
}

/** Waits for #PREVIEW_PAUSE, or until rendering is to stop. */
static void background_renderer_pause(BackgroundRenderer *background) {
    struct timespec until = clock_deadline(PREVIEW_PAUSE);
    int code = 0;
    pthread_mutex_lock(&background->mutex);
    while (code == 0 && !atomic_load(&background->stop)) {
        code = pthread_cond_timedwait(&background->wake, &background->mutex, &until);
    }
    pthread_mutex_unlock(&background->mutex);
}

/** Renders the requested picture, pass by pass, until it is finished or stopped. */
static void background_renderer_render(Renderer *renderer) {
    BackgroundRenderer *background = &renderer->background;
    LayerPasses passes = layer_passes(renderer);
    RenderPass pass =
        renderer_make_pass(renderer, background->width, background->height, &background->stop);
    pass.accumulator = &renderer->accumulator;
    pass.layer = renderer->layer_renderer.layer;
    // A layer has colours only when all of its numbers are known.
    pass.on_tile = pass.layer == LAYER_SHADED ? background_renderer_on_tile : NULL;
    atomic_store(&background->next_part_time, pass.start + PART_INTERVAL);
    PassRange next = {0};
    bool is_more = pass_range_next(&next, passes.samples, passes.has_preview);
    while (is_more) {
        pass.range = next;
        pass.picture = &background->back;
        if (!passes.run(&pass)) {
            return;
        }
        pass.on_tile = NULL;
        is_more = pass_range_next(&next, passes.samples, passes.has_preview);
        RenderStats stats = render_pass_stats(&pass, !is_more);
        background_renderer_publish(renderer, &stats);
        if (pass.range.is_preview) {
            background_renderer_pause(background);
        }
    }
}

/** Main function of the thread: renders on request. @return NULL */
static void *background_renderer_main(void *argument) {
    Renderer *renderer = argument;
    BackgroundRenderer *background = &renderer->background;
    pthread_mutex_lock(&background->mutex);
    while (true) {
        while (!background->is_requested && !background->is_stopping) {
            pthread_cond_wait(&background->wake, &background->mutex);
        }
        if (background->is_stopping) {
            break;
        }
        background->is_requested = false;
        background->is_rendering = true;
        pthread_mutex_unlock(&background->mutex);
        background_renderer_render(renderer);
        pthread_mutex_lock(&background->mutex);
        background->is_rendering = false;
        pthread_cond_signal(&background->idle);
    }
    pthread_mutex_unlock(&background->mutex);
    return NULL;
}

void renderer_stop(Renderer *renderer) {
    BackgroundRenderer *background = &renderer->background;
    atomic_store(&background->stop, true);
    pthread_mutex_lock(&background->mutex);
    background->is_requested = false;
    pthread_cond_signal(&background->wake); // It may pause.
    while (background->is_rendering) {
        pthread_cond_wait(&background->idle, &background->mutex);
    }
    pthread_mutex_unlock(&background->mutex);
}

/** Frees the pictures. */
static void background_buffers_deinit(BackgroundRenderer *background) {
    picture_deinit(&background->back);
    picture_deinit(&background->front);
    free(background->tiles);
    background->tiles = NULL;
}

/**
 * Resizes the pictures and the accumulator.
 * @param renderer  The renderer; its background part is idle.
 * @return false without memory.
 */
static bool background_buffers_resize(Renderer *renderer, int width, int height, Error *error) {
    BackgroundRenderer *background = &renderer->background;
    if (background->front.pixels && background->width == width && background->height == height) {
        return true;
    }
    background_buffers_deinit(background);
    background->width = width;
    background->height = height;
    bool is_made = sample_accumulator_resize(&renderer->accumulator, width, height,
                                             renderer_is_adaptive(renderer), error) &&
                   picture_init(&background->back, width, height, error) &&
                   picture_init(&background->front, width, height, error);
    background->tiles = calloc(tile_count(width, height), sizeof *background->tiles);
    if (is_made && !background->tiles) {
        is_made =
            error_set(error, STATUS_FAILED, "no memory for %zu tiles", tile_count(width, height));
    }
    if (!is_made) {
        background_buffers_deinit(background);
    }
    return is_made;
}

/** Starts the thread, once. @return Whether it runs. */
static bool background_renderer_start_thread(Renderer *renderer, Error *error) {
    BackgroundRenderer *background = &renderer->background;
    if (!background->is_running) {
        int code = ray_thread_create(&background->thread, background_renderer_main, renderer);
        if (code != 0) {
            return error_set(error, STATUS_FAILED, "cannot start a thread: %s",
                             error_errno_text(code));
        }
        background->is_running = true;
    }
    return true;
}

bool renderer_start(Renderer *renderer, const Scene *scene, int width, int height,
                    RenderPassCallback callback, void *context, Error *error) {
    BackgroundRenderer *background = &renderer->background;
    renderer_stop(renderer);
    if (!background_renderer_start_thread(renderer, error) ||
        !background_buffers_resize(renderer, width, height, error) ||
        !layer_renderer_prepare(renderer, scene, width, height, error)) {
        return false;
    }
    renderer->settings.engine->set_view(renderer->tracer, scene, width, height);
    atomic_store(&renderer->rays_done, 0);
    LayerPasses passes = layer_passes(renderer);
    atomic_store(&renderer->rays_total,
                 pass_range_total_rays(width, height, passes.samples, passes.has_preview));
    pthread_mutex_lock(&background->mutex);
    background->callback = callback;
    background->context = context;
    background->has_front = background->has_part = false;
    for (size_t i = 0; i < tile_count(width, height); i++) {
        atomic_store_explicit(&background->tiles[i], false, memory_order_relaxed);
    }
    background->is_requested = true;
    atomic_store(&background->stop, false);
    pthread_cond_signal(&background->wake);
    pthread_mutex_unlock(&background->mutex);
    return true;
}

/** Copies a rectangle of a picture in the byte order of screens. @param pitch Bytes from a row of
 *  the whole to the next. */
static void copy_bgrx(const Picture *picture, const PixelGrid *rectangle, uint8_t *bgrx,
                      int pitch) {
    for (int y = rectangle->y; y < rectangle->y + rectangle->rows; y++) {
        size_t first = (size_t)y * (size_t)picture->width + (size_t)rectangle->x;
        const uint8_t *from = picture->pixels + 3 * first;
        uint8_t *to = bgrx + (ptrdiff_t)y * pitch + (ptrdiff_t)4 * rectangle->x;
        for (int x = 0; x < rectangle->columns; x++, from += 3, to += 4) {
            to[0] = from[2];
            to[1] = from[1];
            to[2] = from[0];
            to[3] = UINT8_MAX;
        }
    }
}

/** Copies the tiles of the first pass that are done. */
static void copy_tiles(const BackgroundRenderer *background, uint8_t *bgrx, int pitch) {
    const Picture *back = &background->back;
    for (size_t i = 0; i < tile_count(back->width, back->height); i++) {
        if (atomic_load_explicit(&background->tiles[i], memory_order_acquire)) {
            PixelGrid tile = tile_at(back->width, back->height, i);
            copy_bgrx(back, &tile, bgrx, pitch);
        }
    }
}

bool renderer_copy_latest(Renderer *renderer, RenderStats *stats, uint8_t *bgrx, int pitch) {
    BackgroundRenderer *background = &renderer->background;
    pthread_mutex_lock(&background->mutex);
    bool is_available = background->has_front || background->has_part;
    if (is_available) {
        *stats = background->stats;
    }
    if (is_available && bgrx) {
        const Picture *front = &background->front;
        PixelGrid whole = {.columns = front->width, .rows = front->height};
        copy_bgrx(front, &whole, bgrx, pitch);
        if (!background->has_front) {
            copy_tiles(background, bgrx, pitch);
        }
    }
    pthread_mutex_unlock(&background->mutex);
    return is_available;
}

/** @return The numbers of a pixel of the newest pass of a layer. The mutex is held. */
static const float *front_values_at(const Renderer *renderer, int x, int y) {
    size_t stride = (size_t)renderer->background.stats.stride;
    size_t columns = ((size_t)renderer->background.front.width + stride - 1) / stride;
    size_t cell = (size_t)y / stride * columns + (size_t)x / stride;
    return renderer->layer_renderer.front_values + LAYER_VALUES * cell;
}

/** @return Whether the newest pass has numbers. The mutex is held. */
static bool has_front_values(const Renderer *renderer) {
    const BackgroundRenderer *background = &renderer->background;
    return background->has_front && background->stats.layer.layer != LAYER_SHADED &&
           renderer->layer_renderer.front_values;
}

bool renderer_read_pixel(Renderer *renderer, int x, int y, PixelReading *reading) {
    BackgroundRenderer *background = &renderer->background;
    pthread_mutex_lock(&background->mutex);
    const Picture *picture = &background->front;
    bool is_available =
        background->has_front && x >= 0 && y >= 0 && x < picture->width && y < picture->height;
    *reading = (PixelReading){.layer = background->stats.layer.layer, .shape = -1};
    if (is_available) {
        size_t pixel = (size_t)y * (size_t)picture->width + (size_t)x;
        memcpy(reading->rgb, picture->pixels + 3 * pixel, sizeof reading->rgb);
    }
    if (is_available && has_front_values(renderer)) {
        memcpy(reading->values, front_values_at(renderer, x, y), sizeof reading->values);
    }
    pthread_mutex_unlock(&background->mutex);
    if (is_available) {
        PixelGrid grid = {.x = x, .y = y, .columns = 1, .rows = 1, .stride = 1};
        renderer->settings.engine->trace_primary(renderer->tracer, &grid, &reading->shape,
                                                 &reading->distance);
    }
    return is_available;
}

void renderer_copy_part(Renderer *renderer, int x, int y, int columns, int rows, uint8_t *rgb) {
    BackgroundRenderer *background = &renderer->background;
    pthread_mutex_lock(&background->mutex);
    const Picture *picture = &background->front;
    for (int i = 0; background->has_front && i < columns * rows; i++) {
        int column = x + i % columns, row = y + i / columns;
        if (column >= 0 && column < picture->width && row >= 0 && row < picture->height) {
            size_t pixel = (size_t)row * (size_t)picture->width + (size_t)column;
            memcpy(rgb + 3 * i, picture->pixels + 3 * pixel, 3);
        }
    }
    pthread_mutex_unlock(&background->mutex);
}

bool renderer_copy_values(Renderer *renderer, RenderStats *stats, float *values) {
    BackgroundRenderer *background = &renderer->background;
    pthread_mutex_lock(&background->mutex);
    bool is_available = has_front_values(renderer);
    if (is_available) {
        *stats = background->stats;
    }
    for (int y = 0; is_available && y < background->front.height; y++) {
        for (int x = 0; x < background->front.width; x++, values += LAYER_VALUES) {
            memcpy(values, front_values_at(renderer, x, y), LAYER_VALUES * sizeof *values);
        }
    }
    pthread_mutex_unlock(&background->mutex);
    return is_available;
}

void renderer_copy_marks(Renderer *renderer, LayerMarks *marks) {
    pthread_mutex_lock(&renderer->background.mutex);
    *marks = has_front_values(renderer) ? renderer->layer_renderer.front_marks
                                        : (LayerMarks){.count = 0};
    pthread_mutex_unlock(&renderer->background.mutex);
}

void background_renderer_deinit(BackgroundRenderer *background) {
    if (background->is_running) {
        pthread_mutex_lock(&background->mutex);
        atomic_store(&background->stop, true);
        background->is_stopping = true;
        pthread_cond_signal(&background->wake);
        pthread_mutex_unlock(&background->mutex);
        pthread_join(background->thread, NULL);
    }
    background_buffers_deinit(background);
    pthread_cond_destroy(&background->wake);
    pthread_cond_destroy(&background->idle);
    pthread_mutex_destroy(&background->mutex);
}
