/**
 * @file
 * @brief Rendering one picture of the window in the background.
 */
#include "view/window/viewport.h"

/** Seconds after a change before a coarse pass is shown instead of one with all pixels. Half a
 * frame of a 60 Hz screen: the other half is left for showing it. */
static const double FULL_RESOLUTION_WAIT = 0.008;
/** The same, seconds, where all pixels would come much too late: time for a second coarse pass. */
static const double COARSE_WAIT = 0.004;
/** How many times #FULL_RESOLUTION_WAIT the last picture took where the next is not waited for. */
static const double SLOW_RATIO = 3;

/** @return Seconds after a change before a coarse pass is shown. See #FULL_RESOLUTION_WAIT. */
static double coarse_wait(const Viewport *viewport) {
    bool is_slow = viewport->render_seconds > SLOW_RATIO * FULL_RESOLUTION_WAIT;
    return is_slow ? COARSE_WAIT : FULL_RESOLUTION_WAIT;
}

bool viewport_open(Viewport *viewport, const Viewport *reuse_from, const Scene *scene,
                   const RenderSettings *base, uint32_t pass_event, Error *error) {
    viewport->pass_event = pass_event;
    viewport->settings = *base;
    settings_override_apply(&viewport->overrides, &viewport->settings);
    viewport->needs_restart = true;
    viewport->needs_new_renderer = viewport->awaits_first_frame = viewport->has_new_pass = false;
    viewport->render_seconds = viewport->previous_render_seconds = 0;
    viewport->report = (RenderStats){0};
    viewport->renderer = renderer_create_reusing(reuse_from ? reuse_from->renderer : NULL, scene,
                                                 &viewport->settings, error);
    if (viewport->renderer) {
        renderer_set_layer(viewport->renderer, viewport->layer);
    }
    return viewport->renderer != NULL;
}

void viewport_close(Viewport *viewport) {
    renderer_destroy(viewport->renderer);
    viewport->renderer = NULL;
    streaming_texture_release(&viewport->texture);
}

/** Begins to compare the cost of the next render with that of the last. */
static void start_cost_comparison(Viewport *viewport) {
    viewport->previous_render_seconds =
        viewport->render_seconds > 0 ? viewport->render_seconds : viewport->previous_render_seconds;
    viewport->render_seconds = 0;
}

void viewport_override_setting(Viewport *viewport, const RenderSettings *base,
                               SettingsChangeFn *change, int step) {
    RenderSettings current = *base; // The renderer may still have settings of before.
    settings_override_apply(&viewport->overrides, &current);
    change(&viewport->overrides, &current, step);
    viewport->needs_new_renderer = viewport->needs_restart = true;
}

void viewport_set_layer(Viewport *viewport, Layer layer) {
    start_cost_comparison(viewport);
    viewport->layer = layer;
    viewport->is_report_old = true;
    renderer_set_layer(viewport->renderer, layer);
    viewport->needs_restart = true;
    viewport->awaits_first_frame = false;
}

void viewport_choose(Viewport *viewport, const RenderSettings *base,
                     const SettingsOverride *overrides, Layer layer) {
    RenderSettings before = *base, after = *base;
    settings_override_apply(&viewport->overrides, &before);
    settings_override_apply(overrides, &after);
    viewport->overrides = *overrides;
    if (settings_difference(&before, &after) != 0) {
        viewport->needs_new_renderer = viewport->needs_restart = true;
    }
    if (viewport->renderer && viewport->layer != layer) {
        viewport_set_layer(viewport, layer);
    }
    viewport->layer = layer;
}

void viewport_set_renderer(Viewport *viewport, Renderer *renderer, const RenderSettings *settings) {
    renderer_destroy(viewport->renderer);
    viewport->renderer = renderer;
    viewport->settings = *settings;
    viewport->is_report_old = true;
    renderer_set_layer(renderer, viewport->layer);
    viewport->needs_restart = true;
    viewport->awaits_first_frame = viewport->has_new_pass = false;
}

bool viewport_update_renderer(Viewport *viewport, const Scene *scene, const RenderSettings *base,
                              Error *error) {
    RenderSettings settings = *base;
    viewport->needs_new_renderer = false;
    settings_override_apply(&viewport->overrides, &settings);
    renderer_stop(viewport->renderer);
    Renderer *renderer = renderer_create_reusing(viewport->renderer, scene, &settings, error);
    if (renderer) {
        start_cost_comparison(viewport);
        viewport_set_renderer(viewport, renderer, &settings);
    }
    return renderer != NULL;
}

/** Sends the event of a finished pass. Called from a thread of the renderer. */
static void on_pass_from_thread(void *context) {
    Viewport *viewport = context;
    if (!atomic_exchange(&viewport->is_event_queued, true)) {
        SDL_Event event = {.user = {.type = viewport->pass_event, .data1 = viewport}};
        if (SDL_PushEvent(&event) != 1) {
            atomic_store(&viewport->is_event_queued, false);
        }
    }
}

void viewport_on_pass(Viewport *viewport) {
    atomic_store(&viewport->is_event_queued, false);
    viewport->has_new_pass = true;
}

bool viewport_stop(Viewport *viewport) {
    bool is_drawing = !viewport_is_finished(viewport);
    if (is_drawing) {
        renderer_stop(viewport->renderer);
        viewport->needs_restart = true;
        viewport->awaits_first_frame = false;
    }
    return is_drawing;
}

bool viewport_start(Viewport *viewport, const Scene *scene, int width, int height, double now,
                    Error *error) {
    viewport->width = width;
    viewport->height = height;
    viewport->needs_restart = viewport->has_new_pass = viewport->report.is_finished = false;
    viewport->start_time = now;
    viewport->awaits_first_frame = renderer_start(viewport->renderer, scene, width, height,
                                                  on_pass_from_thread, viewport, error);
    return viewport->awaits_first_frame;
}

bool viewport_has_frame(Viewport *viewport, double now) {
    RenderStats newest;
    if (viewport->has_new_pass && !renderer_copy_latest(viewport->renderer, &newest, NULL, 0)) {
        viewport->has_new_pass = false;
    }
    bool is_late = now >= viewport->start_time + coarse_wait(viewport);
    return viewport->has_new_pass &&
           (!viewport->awaits_first_frame || is_late || newest.stride == 1);
}

bool viewport_upload(Viewport *viewport, SDL_Renderer *renderer) {
    int pitch = 0;
    viewport->awaits_first_frame = viewport->has_new_pass = false;
    uint8_t *pixels = streaming_texture_lock(&viewport->texture, renderer, viewport->width,
                                             viewport->height, &pitch);
    if (!pixels) {
        return false;
    }
    renderer_copy_latest(viewport->renderer, &viewport->report, pixels, pitch);
    renderer_copy_marks(viewport->renderer, &viewport->marks);
    viewport->is_report_old = false;
    streaming_texture_unlock(&viewport->texture);
    if (viewport->report.full_resolution_seconds > 0) {
        viewport->render_seconds = viewport->report.full_resolution_seconds;
    }
    return true;
}

bool viewport_is_start_due(const Viewport *viewport) {
    return viewport->needs_restart && !viewport->awaits_first_frame;
}

double viewport_timeout(const Viewport *viewport, double now) {
    bool is_coarse_waiting = viewport->has_new_pass && viewport->awaits_first_frame;
    if (viewport_is_start_due(viewport)) {
        return 0;
    }
    return is_coarse_waiting ? fmax(0, viewport->start_time + coarse_wait(viewport) - now)
                             : VIEWPORT_NO_TIMEOUT;
}

bool viewport_is_finished(const Viewport *viewport) {
    return viewport->report.is_finished && !viewport->needs_restart;
}
