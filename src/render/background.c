/**
 * @file
 * @brief Drawing in the background: passes from coarse to fine, stopped and begun again at will.
 */
#include "render/renderer.h"

#include <stdlib.h>
#include <string.h>

void background_init(Background *background) {
    pthread_mutex_init(&background->mutex, NULL);
    pthread_cond_init(&background->is_told, NULL);
    pthread_cond_init(&background->is_idle, NULL);
}

/**
 * Finds the next pass: 8, 4, 2 and 1 pixels a ray, then one more sample a pixel each.
 * @param[in,out] pass  The pass that has ended; `stride` 0 before the first.
 * @param samples       Samples a pixel that are wanted.
 * @return false after the last pass.
 */
static bool pass_next(Pass *pass, int samples) {
    if (pass->stride == 0) {
        *pass = (Pass){.stride = COARSEST_STRIDE};
    } else if (pass->stride > 1) {
        pass->stride /= 2;
    } else {
        pass->first = ++pass->last;
    }
    return pass->last < samples;
}

/** @return Rays from pixels in all passes. @param width Pixels. @param height Pixels.
 *  @param samples Samples a pixel. */
static size_t passes_rays(int width, int height, int samples) {
    size_t rays = 0;
    Pass pass = {0};
    while (pass_next(&pass, samples)) {
        size_t across = ((size_t)width + (size_t)pass.stride - 1) / (size_t)pass.stride;
        size_t down = ((size_t)height + (size_t)pass.stride - 1) / (size_t)pass.stride;
        rays += across * down;
    }
    return rays;
}

void background_publish(Renderer *renderer, const RenderReport *report) {
    Background *background = &renderer->background;
    pthread_mutex_lock(&background->mutex);
    Picture shown = background->back;
    background->back = background->front;
    background->front = shown;
    background->has_front = true;
    background->report = *report;
    RenderListener listener = background->listener;
    void *context = background->context;
    pthread_mutex_unlock(&background->mutex);
    if (listener) {
        listener(context);
    }
}

/** Draws the light asked for, pass by pass, until it is finished or stopped.
 *  @param renderer The renderer. */
static void background_draw(Renderer *renderer) {
    Background *background = &renderer->background;
    int samples = renderer->settings.samples;
    double start = clock_seconds();
    Drawing drawing =
        renderer_drawing(renderer, background->width, background->height, &background->stop);
    drawing.tally = &renderer->tally;
    double whole = 0;
    Pass next = {0};
    bool is_more = pass_next(&next, samples);
    while (is_more) {
        drawing.pass = next;
        drawing.picture = &background->back;
        if (!drawing_pass(&drawing, renderer->workers)) {
            return;
        }
        is_more = pass_next(&next, samples);
        double seconds = clock_seconds() - start;
        whole = drawing.pass.stride == 1 && whole == 0 ? seconds : whole;
        RenderReport report = {.seconds = seconds,
                               .whole_seconds = whole,
                               .rays = drawing_rays(&drawing),
                               .stride = drawing.pass.stride,
                               .samples = drawing.pass.last + 1,
                               .share = renderer_progress(renderer),
                               .is_finished = !is_more};
        background_publish(renderer, &report);
    }
}

/** The thread's life: waits to be asked, draws. @param argument The renderer. @return NULL */
static void *background_main(void *argument) {
    Renderer *renderer = argument;
    Background *background = &renderer->background;
    pthread_mutex_lock(&background->mutex);
    while (true) {
        while (!background->is_wanted && !background->is_over) {
            pthread_cond_wait(&background->is_told, &background->mutex);
        }
        if (background->is_over) {
            break;
        }
        background->is_wanted = false;
        background->is_drawing = true;
        pthread_mutex_unlock(&background->mutex);
        if (renderer->layering.layer == LAYER_SHADED) {
            background_draw(renderer);
        } else {
            layering_draw(renderer);
        }
        pthread_mutex_lock(&background->mutex);
        background->is_drawing = false;
        pthread_cond_signal(&background->is_idle);
    }
    pthread_mutex_unlock(&background->mutex);
    return NULL;
}

void renderer_stop(Renderer *renderer) {
    Background *background = &renderer->background;
    atomic_store(&background->stop, true);
    pthread_mutex_lock(&background->mutex);
    background->is_wanted = false;
    while (background->is_drawing) {
        pthread_cond_wait(&background->is_idle, &background->mutex);
    }
    pthread_mutex_unlock(&background->mutex);
}

/** Gives the pictures back. @param background The background part. */
static void buffers_release(Background *background) {
    picture_release(&background->back);
    picture_release(&background->front);
}

/**
 * Makes room for a picture of another size.
 * @param renderer    The renderer; its background part is idle.
 * @param width       Pixels.
 * @param height      Pixels.
 * @param[out] error  What is wrong.
 * @return false without memory.
 */
static bool buffers_resize(Renderer *renderer, int width, int height, Error *error) {
    Background *background = &renderer->background;
    if (background->front.pixels && background->width == width && background->height == height) {
        return true;
    }
    buffers_release(background);
    background->width = width;
    background->height = height;
    bool is_made =
        tally_resize(&renderer->tally, width, height, renderer_judges(renderer), error) &&
        picture_init(&background->back, width, height, error) &&
        picture_init(&background->front, width, height, error);
    if (!is_made) {
        buffers_release(background);
    }
    return is_made;
}

/** Starts the thread, once. @param renderer The renderer. @param[out] error What is wrong.
 *  @return Whether it runs. */
static bool background_run(Renderer *renderer, Error *error) {
    Background *background = &renderer->background;
    if (!background->is_running) {
        int code = pthread_create(&background->thread, NULL, background_main, renderer);
        if (code != 0) {
            return error_set(error, STATUS_FAILED, "cannot start a thread: %s", error_system(code));
        }
        background->is_running = true;
    }
    return true;
}

bool renderer_start(Renderer *renderer, const Scene *scene, int width, int height,
                    RenderListener listener, void *context, Error *error) {
    Background *background = &renderer->background;
    renderer_stop(renderer);
    if (!background_run(renderer, error) || !buffers_resize(renderer, width, height, error) ||
        !layering_look(renderer, scene, width, height, error)) {
        return false;
    }
    renderer->settings.engine->look(renderer->tracer, scene, width, height);
    atomic_store(&renderer->done, 0);
    atomic_store(&renderer->all, passes_rays(width, height, renderer->settings.samples));
    pthread_mutex_lock(&background->mutex);
    background->listener = listener;
    background->context = context;
    background->has_front = false;
    background->is_wanted = true;
    atomic_store(&background->stop, false);
    pthread_cond_signal(&background->is_told);
    pthread_mutex_unlock(&background->mutex);
    return true;
}

/** Copies a picture in the order of bytes that screens like. @param picture It.
 *  @param[out] bgrx Where to. @param pitch Bytes from a row to the next. */
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

bool renderer_take(Renderer *renderer, RenderReport *report, uint8_t *bgrx, int pitch) {
    Background *background = &renderer->background;
    pthread_mutex_lock(&background->mutex);
    bool is_there = background->has_front;
    if (is_there) {
        *report = background->report;
        if (bgrx) {
            copy_bgrx(&background->front, bgrx, pitch);
        }
    }
    pthread_mutex_unlock(&background->mutex);
    return is_there;
}

void background_release(Background *background) {
    if (background->is_running) {
        pthread_mutex_lock(&background->mutex);
        atomic_store(&background->stop, true);
        background->is_over = true;
        pthread_cond_signal(&background->is_told);
        pthread_mutex_unlock(&background->mutex);
        pthread_join(background->thread, NULL);
    }
    buffers_release(background);
    pthread_cond_destroy(&background->is_told);
    pthread_cond_destroy(&background->is_idle);
    pthread_mutex_destroy(&background->mutex);
}
