/**
 * @file
 * @brief The thread that measures the error of settings.
 */
#include "view/loading/error_meter.h"

#include "render/ray_stack.h"

#include <SDL.h>
#include <math.h>

/** Brightest light that a screen shows. */
static const float WHITE = 1;

/** @return The root of the mean square difference of two pictures, in steps of 255. */
static double rms_difference(const Picture *a, const Picture *b) {
    size_t count = 3 * (size_t)a->width * (size_t)a->height;
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        double x = (double)fminf(a->linear[i], WHITE), y = (double)fminf(b->linear[i], WHITE);
        double difference = encoding_difference(ENCODING_SRGB, x, y);
        sum += difference * difference;
    }
    return sqrt(sum / (double)count);
}

/** Draws the reference, if it is not there, and the picture. @param context The meter. @return
 *  NULL */
static void *error_meter_main(void *context) {
    ErrorMeter *meter = context;
    if (!meter->has_truth) {
        meter->has_truth =
            renderer_render(meter->reference, &meter->stop, &meter->truth).is_finished;
    }
    bool is_done = meter->has_truth &&
                   renderer_render(meter->renderer, &meter->stop, &meter->picture).is_finished;
    meter->error = is_done ? rms_difference(&meter->picture, &meter->truth) : (double)NAN;
    atomic_store(&meter->has_done, true);
    SDL_Event event = {.type = meter->event};
    SDL_PushEvent(&event);
    return NULL;
}

/** @return The settings of the reference. @param small The settings of the small picture. */
static RenderSettings reference_settings(const RenderSettings *small) {
    RenderSettings settings = *small;
    method_set_apply(METHODS_OWN, &settings);
    settings.engine = engine_with_role(ENGINE_DOUBLE);
    settings.samples = ERROR_METER_SAMPLES;
    settings.sampling = SAMPLING_FULL;
    settings.trace.depth = DEPTH_MAXIMUM;
    settings.trace.offset = OFFSET_BOUND;
    settings.trace.pixel_point = PIXEL_CENTER;
    return settings;
}

/** Frees what only one measurement needs. */
static void release_renderers(ErrorMeter *meter) {
    renderer_destroy(meter->renderer);
    renderer_destroy(meter->reference);
    meter->renderer = meter->reference = NULL;
    picture_deinit(&meter->picture);
}

/** Creates a picture with light. */
static bool create_picture(Picture *picture, const RenderSettings *small, Error *error) {
    return picture_init(picture, small->width, small->height, error) &&
           picture_allocate_linear(picture, error);
}

/** Creates renderers and pictures. @return false without memory. */
static bool prepare(ErrorMeter *meter, const Scene *scene, const RenderSettings *small,
                    Error *error) {
    meter->renderer = renderer_create(scene, small, error);
    bool is_made = meter->renderer && create_picture(&meter->picture, small, error);
    if (is_made && !meter->has_truth) {
        RenderSettings settings = reference_settings(small);
        meter->reference = renderer_create_reusing(meter->renderer, scene, &settings, error);
        picture_deinit(&meter->truth);
        is_made = meter->reference && create_picture(&meter->truth, small, error);
    }
    return is_made;
}

bool error_meter_start(ErrorMeter *meter, const Scene *scene, const RenderSettings *settings,
                       Error *error) {
    RenderSettings small = *settings;
    double shrink = sqrt(ERROR_METER_PIXELS / ((double)settings->width * settings->height));
    if (shrink < 1) {
        small.width = SDL_max(1, (int)(settings->width * shrink));
        small.height = SDL_max(1, (int)(settings->height * shrink));
    }
    small.threads = 1; // The picture on screen needs the others.
    atomic_store(&meter->stop, false);
    atomic_store(&meter->has_done, false);
    bool is_started = prepare(meter, scene, &small, error);
    int code = is_started ? ray_thread_create(&meter->thread, error_meter_main, meter) : 0;
    if (code != 0) {
        is_started =
            error_set(error, STATUS_FAILED, "cannot start a thread: %s", error_errno_text(code));
    }
    meter->is_busy = is_started;
    if (!is_started) {
        release_renderers(meter);
    }
    return is_started;
}

bool error_meter_take(ErrorMeter *meter, double *result) {
    if (!meter->is_busy || !atomic_load(&meter->has_done)) {
        return false;
    }
    pthread_join(meter->thread, NULL);
    meter->is_busy = false;
    release_renderers(meter);
    *result = meter->error;
    return true;
}

void error_meter_stop(ErrorMeter *meter) {
    if (meter->is_busy) {
        atomic_store(&meter->stop, true);
        pthread_join(meter->thread, NULL);
        meter->is_busy = false;
    }
    release_renderers(meter);
}

void error_meter_reset(ErrorMeter *meter) {
    error_meter_stop(meter);
    picture_deinit(&meter->truth);
    meter->has_truth = false;
}
