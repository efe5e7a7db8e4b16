/**
 * @file
 * @brief Drawing in the background: passes from coarse to fine, stopped and begun again at will.
 */
#include "render/renderer_internal.h"

#include <stdlib.h>
#include <string.h>

void background_renderer_init(BackgroundRenderer *background) {
    pthread_mutex_init(&background->mutex, NULL);
    pthread_cond_init(&background->wake, NULL);
    pthread_cond_init(&background->idle, NULL);
}

/**
 * Finds the next pass: 8, 4, 2 and 1 pixels a ray, then one more sample a pixel each.
 * @param[in,out] range  The pass that has ended; `stride` 0 before the first.
 * @param samples       Samples a pixel that are wanted.
 * @return false after the last pass.
 */
static bool pass_range_next(PassRange *range, int samples) {
    if (range->stride == 0) {
        *range = (PassRange){.stride = COARSEST_STRIDE};
    } else if (range->stride > 1) {
        range->stride /= 2;
    } else {
        range->first_sample = ++range->last_sample;
    }
    return range->last_sample < samples;
}

/** @return Rays from pixels in all passes. */
static size_t total_ray_count(int width, int height, int samples) {
    size_t rays = 0;
    PassRange range = {0};
    while (pass_range_next(&range, samples)) {
        size_t across = ((size_t)width + (size_t)range.stride - 1) / (size_t)range.stride;
        size_t down = ((size_t)height + (size_t)range.stride - 1) / (size_t)range.stride;
        rays += across * down;
    }
    return rays;
}

void background_renderer_publish(Renderer *renderer, const RenderStats *stats) {
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

/** Draws the light asked for, pass by pass, until it is finished or stopped. */
static void background_renderer_render(Renderer *renderer) {
    BackgroundRenderer *background = &renderer->background;
    int samples = renderer->settings.samples;
    double start = clock_now_seconds();
    RenderPass pass =
        renderer_make_pass(renderer, background->width, background->height, &background->stop);
    pass.accumulator = &renderer->accumulator;
    double full_resolution_seconds = 0;
    PassRange next = {0};
    bool is_more = pass_range_next(&next, samples);
    while (is_more) {
        pass.range = next;
        pass.picture = &background->back;
        if (!render_pass_run(&pass, renderer->thread_pool)) {
            return;
        }
        is_more = pass_range_next(&next, samples);
        double seconds = clock_now_seconds() - start;
        full_resolution_seconds = pass.range.stride == 1 && full_resolution_seconds == 0
                                      ? seconds
                                      : full_resolution_seconds;
        RenderStats stats = {.seconds = seconds,
                             .full_resolution_seconds = full_resolution_seconds,
                             .rays = render_pass_ray_counts(&pass),
                             .stride = pass.range.stride,
                             .samples = pass.range.last_sample + 1,
                             .progress = renderer_progress(renderer),
                             .is_finished = !is_more};
        background_renderer_publish(renderer, &stats);
    }
}

/** The thread's life: waits to be asked, draws. @return NULL */
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
        if (renderer->layer_renderer.layer == LAYER_SHADED) {
            background_renderer_render(renderer);
        } else {
            layer_renderer_render(renderer);
        }
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

/** Gives the pictures back. */
static void background_buffers_deinit(BackgroundRenderer *background) {
    picture_deinit(&background->back);
    picture_deinit(&background->front);
}

/**
 * Makes room for a picture of another size.
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
        int code = pthread_create(&background->thread, NULL, background_renderer_main, renderer);
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
    atomic_store(&renderer->rays_total, total_ray_count(width, height, renderer->settings.samples));
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

/** Copies a picture in the order of bytes that screens like. @param pitch Bytes from a row to the
 *  next. */
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
