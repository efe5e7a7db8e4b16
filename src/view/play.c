/**
 * @file
 * @brief The scene's time in the window.
 *
 * The scene file is run again for each time, in a child of a thread of its own. Nobody waits for
 * it: meanwhile keys and mouse move what is on screen. A new time is asked for when the last answer
 * is on screen, so on a slow machine there are fewer pictures a second, and the time is as fast.
 */
#include "view/play.h"

/** Seconds from one question to the next at least: a frame of a common screen. */
static const double PAUSE = 0.016;

/** @return Whether a view's scene has a time. @param view The view. */
static bool has_time(const View *view) {
    return view->settings->load && view->scene->reads_time;
}

/** Says that there is no time. @param[in,out] view The view. */
static void note_no_time(View *view) {
    view_note(view, "this scene does not ask for the time t");
}

void play_toggle(View *view) {
    if (!has_time(view)) {
        note_no_time(view);
    } else if (view->timeline.is_running) {
        timeline_hold(&view->timeline, stage_clock());
    } else {
        timeline_run(&view->timeline, stage_clock());
    }
    view->title_due = 0;
}

void play_step(View *view, int steps) {
    if (has_time(view)) {
        timeline_step(&view->timeline, steps, stage_clock());
    } else {
        note_no_time(view);
    }
}

/**
 * Puts the scene of another time in the place of the one that is shown.
 * @param[in,out] view  The view.
 * @param reload        The scene and its renderer; the view's from now on.
 * @param[out] error    What is wrong.
 * @return false without memory; nothing is changed then.
 */
static bool replace_scene(View *view, const Reload *reload, Error *error) {
    if (!pose_renew(&view->home, view->scene, reload->scene, error)) {
        renderer_destroy(reload->renderer);
        scene_destroy(reload->scene);
        return false;
    }
    stage_replace(&view->stage, reload->renderer);
    scene_destroy(view->own_scene);
    view->scene = view->own_scene = reload->scene;
    view->light = view->light < view->scene->light_count ? view->light : 0;
    view->time = reload->time;
    view_changed(view);
    return true;
}

/**
 * Takes the scene of another time, if it is there and there is room for it on screen.
 * @param[in,out] view  The view.
 * @param[out] error    What is wrong with it.
 * @return Whether all is well.
 */
static bool take(View *view, Error *error) {
    Reload reload;
    if (!stage_is_ready(&view->stage) || !reloader_take(&view->reloader, &reload)) {
        return true;
    }
    if (reload.renderer && replace_scene(view, &reload, error)) {
        return true;
    }
    if (!reload.renderer) {
        *error = reload.error;
        scene_destroy(reload.scene);
    }
    view->timeline = (Timeline){.time = view->time};
    return false;
}

bool play_update(View *view, double now, Error *error) {
    if (!has_time(view)) {
        return true;
    }
    bool is_good = take(view, error);
    double time = timeline_at(&view->timeline, now);
    if (!is_good || play_delay(view, now) > 0) {
        return is_good;
    }
    view->next_time = now + PAUSE;
    is_good = reloader_ask(&view->reloader, time, view->stage.renderer, error);
    if (!is_good) {
        view->timeline = (Timeline){.time = view->time};
    }
    return is_good;
}

double play_delay(View *view, double now) {
    bool is_due = has_time(view) && timeline_at(&view->timeline, now) != view->time;
    // It came before the last picture was seen, and waits for that; no event tells of it again.
    if (stage_is_ready(&view->stage) && reloader_has_answer(&view->reloader)) {
        return 0;
    }
    bool is_asking = view->timeline.is_running || is_due;
    if (!is_asking || view->stage.is_hidden || reloader_is_busy(&view->reloader)) {
        return STAGE_NEVER;
    }
    return fmax(0, view->next_time - now);
}

bool play_is_at_rest(const View *view) {
    return !view->timeline.is_running && view->timeline.time == view->time;
}

void play_end(View *view) {
    reloader_end(&view->reloader);
    scene_destroy(view->own_scene);
}
