/**
 * @file
 * @brief The picture's way from the scene to the screen.
 */
#include "view/stage.h"

#include "view/snapshot.h"

#include <stdlib.h>
#include <time.h>

/**
 * Seconds after a change that the picture with all its pixels is waited for, before a coarser one
 * is shown instead. Half a frame of a common screen: the other half is left for showing it.
 */
static const double PATIENCE = 0.008;

/** How many times as large letters get with each step. */
static const double TEXT_STEP = 1.2;
/** How many times as large, or as small, as usual they get at most. */
static const double TEXT_RANGE = 3;

double stage_clock(void) {
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

bool stage_open(Stage *stage, const Scene *scene, const RenderSettings *settings, const char *title,
                uint32_t pass_event, Error *error) {
    stage->pass_event = pass_event;
    stage->notice.overlay.place = stage->caption.overlay.place = OVERLAY_BELOW;
    stage->is_changed = true;
    stage->renderer = renderer_create(scene, settings, error);
    return stage->renderer &&
           display_open(&stage->display, title, settings->width, settings->height, error);
}

void stage_close(Stage *stage) {
    renderer_destroy(stage->renderer);
    stage_forget_words(stage);
    display_close(&stage->display);
    latency_release(&stage->latency);
    stage->renderer = NULL;
}

void stage_replace(Stage *stage, Renderer *renderer) {
    renderer_destroy(stage->renderer);
    stage->renderer = renderer;
    stage->is_changed = true;
    stage->has_pass = false;
}

/**
 * Tells the event loop that a pass has ended. Called from a thread of the renderer.
 * @param context  The #Stage.
 */
static void tell_pass(void *context) {
    Stage *stage = context;
    if (!atomic_exchange(&stage->is_told, true)) {
        SDL_Event event = {.type = stage->pass_event};
        if (SDL_PushEvent(&event) != 1) {
            atomic_store(&stage->is_told, false);
        }
    }
}

void stage_on_pass(Stage *stage) {
    atomic_store(&stage->is_told, false);
    stage->has_pass = true;
}

void stage_on_visibility(Stage *stage) {
    Uint32 flags = SDL_GetWindowFlags(stage->display.window);
    stage->is_hidden = flags & (SDL_WINDOW_HIDDEN | SDL_WINDOW_MINIMIZED);
    if (stage->is_hidden && !stage_is_finished(stage)) {
        renderer_stop(stage->renderer);
        latency_forget(&stage->latency);
        stage->is_changed = true;
        stage->is_unseen = false;
    }
}

bool stage_on_resize(Stage *stage) {
    int width, height;
    display_size(&stage->display, &width, &height);
    bool is_other = width != stage->width || height != stage->height;
    if (is_other) {
        stage_forget_words(stage);
        stage->is_changed = true;
    }
    stage_present(stage);
    return is_other;
}

void stage_on_loss(Stage *stage) {
    stage_forget_words(stage);
    display_forget(&stage->display);
    stage->has_pass = true;
}

void stage_present(Stage *stage) {
    double scale = stage->text_scale > 0 ? stage->text_scale : 1;
    OverlayScreen screen = {stage->display.renderer, scale};
    display_begin(&stage->display);
    caption_show(&stage->caption, &screen);
    notice_show(&stage->notice, &screen);
    help_show(&stage->help, &screen);
    display_end(&stage->display);
}

void stage_forget_words(Stage *stage) {
    overlay_forget(&stage->help.overlay);
    overlay_forget(&stage->notice.overlay);
    overlay_forget(&stage->caption.overlay);
}

void stage_resize_words(Stage *stage, int steps) {
    double scale = stage->text_scale > 0 ? stage->text_scale : 1;
    scale *= pow(TEXT_STEP, steps);
    stage->text_scale = steps == 0 ? 0 : SDL_clamp(scale, 1 / TEXT_RANGE, TEXT_RANGE);
    stage_forget_words(stage);
    stage_present(stage);
}

void stage_say(Stage *stage, const char *words) {
    if (notice_say(&stage->notice, words)) {
        stage_present(stage);
    }
}

/**
 * Starts to draw the scene as it is now.
 * @param[in,out] stage  The stage.
 * @param scene          The scene.
 * @param now            Now, seconds.
 * @param[out] error     What is wrong.
 * @return false without memory.
 */
static bool start(Stage *stage, const Scene *scene, double now, Error *error) {
    display_size(&stage->display, &stage->width, &stage->height);
    latency_drawing(&stage->latency);
    stage->is_changed = stage->has_pass = stage->report.is_finished = false;
    stage->started = now;
    stage->is_unseen = renderer_start(stage->renderer, scene, stage->width, stage->height,
                                      tell_pass, stage, error);
    return stage->is_unseen;
}

/** Shows the newest pass. @param[in,out] stage The stage, with a pass. */
static void show(Stage *stage) {
    int pitch = 0;
    stage->is_unseen = stage->has_pass = false;
    uint8_t *pixels = display_lock(&stage->display, stage->width, stage->height, &pitch);
    if (!pixels) {
        return;
    }
    renderer_take(stage->renderer, &stage->report, pixels, pitch);
    display_unlock(&stage->display);
    stage_present(stage);
    double shown = stage_clock();
    latency_shown(&stage->latency, shown);
    stage->first_shown = stage->first_shown > 0 ? stage->first_shown : shown;
}

bool stage_update(Stage *stage, const Scene *scene, double now, Error *error) {
    if (stage->is_hidden) {
        return true;
    }
    if (stage->is_changed && !stage->is_unseen && !start(stage, scene, now, error)) {
        return false;
    }
    RenderReport newest;
    if (stage->has_pass && !renderer_take(stage->renderer, &newest, NULL, 0)) {
        stage->has_pass = false;
    }
    bool is_late = now >= stage->started + PATIENCE;
    if (stage->has_pass && (!stage->is_unseen || is_late || newest.stride == 1)) {
        show(stage);
    }
    return true;
}

double stage_delay(const Stage *stage, double now) {
    bool is_coarse_waiting = stage->has_pass && stage->is_unseen && !stage->is_hidden;
    return is_coarse_waiting ? fmax(0, stage->started + PATIENCE - now) : STAGE_NEVER;
}

bool stage_is_ready(const Stage *stage) {
    return !stage->is_unseen && !stage->is_hidden;
}

bool stage_is_finished(const Stage *stage) {
    return stage->report.is_finished && !stage->is_changed;
}

bool stage_copy(const Stage *stage, Picture *picture, Error *error) {
    size_t row = (size_t)stage->width * 4;
    uint8_t *bgrx = malloc(row * (size_t)stage->height);
    if (!bgrx) {
        return error_set(error, STATUS_FAILED, "no memory for a snapshot");
    }
    RenderReport report;
    bool is_copied = picture_init(picture, stage->width, stage->height, error);
    if (is_copied) {
        renderer_take(stage->renderer, &report, bgrx, (int)row);
        snapshot_convert(bgrx, picture);
    }
    free(bgrx);
    return is_copied;
}
