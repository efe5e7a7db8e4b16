/**
 * @file
 * @brief One picture of the window.
 */
#include "view/sight.h"

/**
 * Seconds after a change that the picture with all its pixels is waited for, before a coarser one
 * is shown instead. Half a frame of a common screen: the other half is left for showing it.
 */
static const double PATIENCE = 0.008;

bool sight_open(Sight *sight, const Sight *former, const Scene *scene, const RenderSettings *asked,
                uint32_t pass_event, Error *error) {
    sight->pass_event = pass_event;
    sight->settings = *asked;
    tuning_apply(&sight->tuning, &sight->settings);
    sight->is_changed = true;
    sight->is_tuned = sight->is_unseen = sight->has_pass = false;
    sight->cost = sight->cost_before = 0;
    sight->report = (RenderReport){0};
    sight->renderer =
        renderer_create_after(former ? former->renderer : NULL, scene, &sight->settings, error);
    if (sight->renderer) {
        renderer_set_layer(sight->renderer, sight->layer);
    }
    return sight->renderer != NULL;
}

void sight_close(Sight *sight) {
    renderer_destroy(sight->renderer);
    sight->renderer = NULL;
    canvas_forget(&sight->canvas);
}

/** Begins to compare what comes with what is. @param[in,out] sight The sight. */
static void compare_costs(Sight *sight) {
    sight->cost_before = sight->cost > 0 ? sight->cost : sight->cost_before;
    sight->cost = 0;
}

void sight_tune(Sight *sight, Action action) {
    RenderSettings now = sight->settings;
    tuning_apply(&sight->tuning, &now);
    tuning_change(&sight->tuning, &now, action);
    sight->is_tuned = sight->is_changed = true;
}

void sight_set_layer(Sight *sight, Layer layer) {
    compare_costs(sight);
    sight->layer = layer;
    renderer_set_layer(sight->renderer, layer);
    sight->is_changed = true;
    sight->is_unseen = false;
}

void sight_replace(Sight *sight, Renderer *renderer, const RenderSettings *settings) {
    renderer_destroy(sight->renderer);
    sight->renderer = renderer;
    sight->settings = *settings;
    renderer_set_layer(renderer, sight->layer);
    sight->is_changed = true;
    sight->is_unseen = sight->has_pass = false;
}

bool sight_remake(Sight *sight, const Scene *scene, const RenderSettings *asked, Error *error) {
    RenderSettings settings = *asked;
    sight->is_tuned = false;
    tuning_apply(&sight->tuning, &settings);
    renderer_stop(sight->renderer);
    Renderer *renderer = renderer_create_after(sight->renderer, scene, &settings, error);
    if (renderer) {
        compare_costs(sight);
        sight_replace(sight, renderer, &settings);
    }
    return renderer != NULL;
}

/**
 * Tells the event loop that a pass has ended. Called from a thread of the renderer.
 * @param context  The #Sight.
 */
static void tell_pass(void *context) {
    Sight *sight = context;
    if (!atomic_exchange(&sight->is_told, true)) {
        SDL_Event event = {.user = {.type = sight->pass_event, .data1 = sight}};
        if (SDL_PushEvent(&event) != 1) {
            atomic_store(&sight->is_told, false);
        }
    }
}

void sight_on_pass(Sight *sight) {
    atomic_store(&sight->is_told, false);
    sight->has_pass = true;
}

bool sight_stop(Sight *sight) {
    bool is_drawing = !sight_is_finished(sight);
    if (is_drawing) {
        renderer_stop(sight->renderer);
        sight->is_changed = true;
        sight->is_unseen = false;
    }
    return is_drawing;
}

bool sight_start(Sight *sight, const Scene *scene, int width, int height, double now,
                 Error *error) {
    sight->width = width;
    sight->height = height;
    sight->is_changed = sight->has_pass = sight->report.is_finished = false;
    sight->started = now;
    sight->is_unseen =
        renderer_start(sight->renderer, scene, width, height, tell_pass, sight, error);
    return sight->is_unseen;
}

bool sight_is_due(Sight *sight, double now) {
    RenderReport newest;
    if (sight->has_pass && !renderer_take(sight->renderer, &newest, NULL, 0)) {
        sight->has_pass = false;
    }
    bool is_late = now >= sight->started + PATIENCE;
    return sight->has_pass && (!sight->is_unseen || is_late || newest.stride == 1);
}

bool sight_show(Sight *sight, SDL_Renderer *renderer) {
    int pitch = 0;
    sight->is_unseen = sight->has_pass = false;
    uint8_t *pixels = canvas_lock(&sight->canvas, renderer, sight->width, sight->height, &pitch);
    if (!pixels) {
        return false;
    }
    renderer_take(sight->renderer, &sight->report, pixels, pitch);
    canvas_unlock(&sight->canvas);
    if (sight->report.whole_seconds > 0) {
        sight->cost = sight->report.whole_seconds;
    }
    return true;
}

double sight_delay(const Sight *sight, double now) {
    bool is_coarse_waiting = sight->has_pass && sight->is_unseen;
    return is_coarse_waiting ? fmax(0, sight->started + PATIENCE - now) : SIGHT_NEVER;
}

bool sight_is_finished(const Sight *sight) {
    return sight->report.is_finished && !sight->is_changed;
}
