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
