/**
 * @file
 * @brief Rendering in the background: passes coarse to fine, double-buffered, restarted at will.
 */
#include "render/ray_stack.h"
#include "render/renderer_internal.h"

#include <stdlib.h>
#include <string.h>

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

/** Renders the requested picture, pass by pass, until it is finished or stopped. */
static void background_renderer_render(Renderer *renderer) {
    BackgroundRenderer *background = &renderer->background;
    LayerPasses passes = layer_passes(renderer);
    RenderPass pass =
        renderer_make_pass(renderer, background->width, background->height, &background->stop);
    pass.accumulator = &renderer->accumulator;
    pass.layer = renderer->layer_renderer.layer;
    PassRange next = {0};
    bool is_more = pass_range_next(&next, passes.samples, passes.has_preview);
    while (is_more) {
        pass.range = next;
        pass.picture = &background->back;
        if (!passes.run(&pass)) {
            return;
        }
        is_more = pass_range_next(&next, passes.samples, passes.has_preview);
        RenderStats stats = render_pass_stats(&pass, !is_more);
        background_renderer_publish(renderer, &stats);
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
    while (background->is_rendering) {
        pthread_cond_wait(&background->idle, &background->mutex);
    }
    pthread_mutex_unlock(&background->mutex);
}

/** Frees the pictures. */
static void background_buffers_deinit(BackgroundRenderer *background) {
    picture_deinit(&background->back);
    picture_deinit(&background->front);
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
    background->has_front = false;
    background->is_requested = true;
    atomic_store(&background->stop, false);
    pthread_cond_signal(&background->wake);
    pthread_mutex_unlock(&background->mutex);
    return true;
}

/** Copies a picture in the byte order of screens. @param pitch Bytes from a row to the next. */
static void copy_bgrx(const Picture *picture, uint8_t *bgrx, int pitch) {
    const uint8_t *from = picture->pixels;
    for (int y = 0; y < picture->height; y++) {
        uint8_t *to = bgrx + (ptrdiff_t)y * pitch;
        for (int x = 0; x < picture->width; x++, from += 3, to += 4) {
            to[0] = from[2];
            to[1] = from[1];
            to[2] = from[0];
            to[3] = UINT8_MAX;
        }
    }
}

bool renderer_copy_latest(Renderer *renderer, RenderStats *stats, uint8_t *bgrx, int pitch) {
    BackgroundRenderer *background = &renderer->background;
    pthread_mutex_lock(&background->mutex);
    bool is_available = background->has_front;
    if (is_available) {
        *stats = background->stats;
        if (bgrx) {
            copy_bgrx(&background->front, bgrx, pitch);
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
