/**
 * @file
 * @brief Renders small pictures, compares and times them.
 */
#include "lab/needs/trial.h"

#include "base/clock.h"
#include "base/encoding.h"
#include "lab/needs/scaled_tolerance.h"

#include <math.h>

/** @return How a renderer is set up for a trial. */
static RenderSettings render_settings_of(const TrialStage *stage, const NeedsSettings *settings) {
    RenderSettings render = {.engine = settings->engine,
                             .threads = stage->threads,
                             .width = stage->width,
                             .height = stage->height,
                             .samples = settings->samples < stage->samples ? settings->samples
                                                                           : stage->samples,
                             .sampling = SAMPLING_FULL,
                             .encoding = stage->scene->image.encoding,
                             .lighting = stage->lighting,
                             .trace = *stage->trace};
    render.trace.depth = settings->depth;
    render.trace.cutoff = settings->cutoff;
    render.trace.offset = settings->offset;
    return render;
}

/** Renders a scene. @param picture Empty: it is only timed. @return false if anything is wrong. */
static bool scene_render(const TrialStage *stage, const Scene *scene, const NeedsSettings *settings,
                         TrialPicture *picture, Error *error) {
    RenderSettings render = render_settings_of(stage, settings);
    Renderer *renderer = renderer_create(scene, &render, error);
    if (!renderer) {
        return false;
    }
    double start = clock_thread_cpu_seconds();
    RenderStats stats =
        renderer_render(renderer, stage->stop, picture->picture.linear ? &picture->picture : NULL);
    picture->cpu_seconds = clock_thread_cpu_seconds() - start;
    picture->seconds = stats.seconds;
    renderer_destroy(renderer);
    return stats.is_finished || error_set(error, STATUS_INTERRUPTED, "interrupted");
}

/** Renders the scene with the tolerances of a trial. @return false if anything is wrong. */
static bool stage_render(const TrialStage *stage, const NeedsSettings *settings,
                         TrialPicture *picture, Error *error) {
    if (settings->tolerance == 1) {
        return scene_render(stage, stage->scene, settings, picture, error);
    }
    ScaledToleranceScene scaled;
    if (!scaled_tolerance_scene_init(&scaled, stage->scene, settings->tolerance, error)) {
        return false;
    }
    bool is_done = scene_render(stage, &scaled.scene, settings, picture, error);
    scaled_tolerance_scene_deinit(&scaled);
    return is_done;
}

bool trial_render(const TrialStage *stage, const NeedsSettings *settings, TrialPicture *picture,
                  Error *error) {
    *picture = (TrialPicture){0};
    bool is_done = picture_init(&picture->picture, stage->width, stage->height, error) &&
                   picture_allocate_linear(&picture->picture, error) &&
                   stage_render(stage, settings, picture, error);
    if (!is_done) {
        trial_picture_deinit(picture);
    }
    return is_done;
}

void trial_picture_deinit(TrialPicture *picture) {
    picture_deinit(&picture->picture);
}

/** @return Light as it is displayed, 8-bit steps. NaN is displayed as black. */
static double displayed_steps(float light, Encoding encoding) {
    double inside = light > 0 ? (light < 1 ? (double)light : 1) : 0;
    return encoding_encode(encoding, inside);
}

NeedsTrial trial_compare(const TrialStage *stage, const TrialPicture *a, const TrialPicture *b) {
    Encoding encoding = (Encoding)stage->scene->image.encoding;
    NeedsTrial trial = {.pixels = (size_t)stage->width * (size_t)stage->height};
    double squares = 0;
    for (size_t pixel = 0; pixel < trial.pixels; pixel++) {
        double worst = 0;
        for (size_t i = 3 * pixel; i < 3 * pixel + 3; i++) {
            float here = a->picture.linear[i], there = b->picture.linear[i];
            double steps =
                here == there
                    ? 0
                    : fabs(displayed_steps(here, encoding) - displayed_steps(there, encoding));
            worst = fmax(worst, steps);
            squares += steps * steps;
        }
        trial.off += worst >= stage->error_steps;
        trial.max_steps = fmax(trial.max_steps, worst);
    }
    trial.rms_steps = sqrt(squares / (3 * (double)trial.pixels));
    return trial;
}

bool trial_run(const TrialStage *stage, const NeedsSettings *settings,
               const TrialPicture *reference, NeedsTrial *trial, Error *error) {
    TrialPicture picture;
    if (!trial_render(stage, settings, &picture, error)) {
        return false;
    }
    *trial = trial_compare(stage, &picture, reference);
    trial_picture_deinit(&picture);
    return true;
}

bool trial_time(const TrialStage *stage, const NeedsSettings *settings, size_t count, int turns,
                TrialTime *times, Error *error) {
    for (int turn = 0; turn < turns; turn++) {
        for (size_t i = 0; i < count; i++) {
            TrialPicture timed = {0};
            if (!stage_render(stage, &settings[i], &timed, error)) {
                return false;
            }
            TrialTime *time = &times[i];
            time->cpu_least =
                turn == 0 ? timed.cpu_seconds : fmin(time->cpu_least, timed.cpu_seconds);
            time->cpu_most =
                turn == 0 ? timed.cpu_seconds : fmax(time->cpu_most, timed.cpu_seconds);
            time->least = turn == 0 ? timed.seconds : fmin(time->least, timed.seconds);
        }
    }
    return true;
}

bool trial_time_processor(const TrialStage *stage, const NeedsSettings *settings, size_t count,
                          int turns, TrialTime *times, Error *error) {
    TrialStage alone = *stage;
    alone.threads = 1;
    return trial_time(&alone, settings, count, turns, times, error);
}

bool trial_time_is_faster(const TrialTime *a, const TrialTime *b) {
    return a->cpu_most < b->cpu_least;
}
