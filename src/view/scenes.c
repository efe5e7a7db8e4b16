/**
 * @file
 * @brief Scenes come and go while the window stays.
 *
 * A scene file is run in a child of a thread of its own. Nobody waits for it: meanwhile keys and
 * mouse move what is on screen. A new time is asked for when the last answer is on screen, so on a
 * slow machine there are fewer pictures a second, and the time is as fast. A scene that cannot be
 * had leaves the one before on screen, with words over it.
 */
#include "view/scenes.h"

#include "dioptre/scene_name.h"
#include "view/play.h"

#include <string.h>

/** Seconds from one question to the next at least: a frame of a common screen. */
static const double PAUSE = 0.016;

/** Goes by a file from now on. @param[in,out] view The view. @param path The file, or `-`. */
static void go_by(View *view, const char *path) {
    scene_name(path, view->name, sizeof view->name);
    SDL_strlcpy(view->path, path, sizeof view->path);
    if (view->settings->load && strcmp(path, "-") != 0) {
        watch_file(&view->watch, path);
    }
}

void scenes_begin(View *view) {
    watch_begin(&view->watch, view->first_event + EVENT_FILE);
    go_by(view, view->settings->path);
}

void scenes_refresh(View *view) {
    view->is_outdated = true;
}

void scenes_open(View *view, const char *path) {
    if (view->settings->load) {
        SDL_strlcpy(view->next_path, path, sizeof view->next_path);
    }
}

void scenes_repeat_error(View *view) {
    if (view->is_wrong && view->wrong_path[0] != '\0') {
        scenes_open(view, view->wrong_path);
    } else if (view->is_wrong) {
        scenes_refresh(view);
    }
}

/** Keeps where camera and lights are, and puts back what the user has moved; in another scene,
 *  nothing was. @param[in,out] view The view. @param reload The new scene.
 *  @param[out] error What is wrong. @return false without memory; nothing is changed then. */
static bool renew_pose(View *view, const Reload *reload, Error *error) {
    if (reload->path[0] == '\0') {
        return pose_renew(&view->home, view->scene, reload->scene, error);
    }
    Pose home;
    if (!pose_save(&home, reload->scene, error)) {
        return false;
    }
    pose_release(&view->home);
    view->home = home;
    return true;
}

/** Draws another scene from now on. A picture that has come meanwhile is made for it next.
 *  @param[in,out] stage The stage. @param[in,out] reload The scene and its renderers. */
static void replace_pictures(Stage *stage, Reload *reload) {
    stage->asked = reload->asked;
    for (size_t i = 0; i < STAGE_SIGHTS; i++) {
        ReloadPicture *picture = &reload->pictures[i];
        if (picture->renderer && stage->sights[i].renderer) {
            sight_replace(&stage->sights[i], picture->renderer, &picture->settings);
            inspector_on_replace(&stage->inspector);
        } else {
            renderer_destroy(picture->renderer);
            stage->sights[i].is_tuned = true;
        }
    }
}

/**
 * Puts a scene in the place of the one that is shown.
 * @param[in,out] view  The view.
 * @param[in,out] reload  The scene and its renderers; the view's from now on.
 * @param[out] error    What is wrong.
 * @return false without memory; nothing is changed then.
 */
static bool replace_scene(View *view, Reload *reload, Error *error) {
    if (!renew_pose(view, reload, error)) {
        reload_release(reload);
        return false;
    }
    replace_pictures(&view->stage, reload);
    scene_destroy(view->own_scene);
    view->scene = view->own_scene = reload->scene;
    view->light = view->light < view->scene->light_count ? view->light : 0;
    view->time = reload->time;
    if (reload->path[0] != '\0') {
        go_by(view, reload->path);
        view->timeline = (Timeline){.time = reload->time};
    }
    view->is_wrong = false;
    view_changed(view);
    return true;
}

/**
 * Takes the scene that was asked for, if it is there and there is room for it on screen.
 * @param[in,out] view  The view.
 * @param[out] error    What is wrong with it.
 * @return Whether all is well.
 */
static bool take(View *view, Error *error) {
    Reload reload;
    if (!stage_is_ready(&view->stage) || !reloader_take(&view->reloader, &reload)) {
        return true;
    }
    bool is_whole = reload_is_whole(&reload);
    if (is_whole && replace_scene(view, &reload, error)) {
        return true;
    }
    if (!is_whole) {
        *error = reload.error;
        reload_release(&reload);
        stage_retune(&view->stage);
    }
    view->is_wrong = true;
    SDL_strlcpy(view->wrong_path, reload.path, sizeof view->wrong_path);
    view->timeline = (Timeline){.time = view->time};
    return false;
}

/** @return Whether another scene is wanted than the one that is shown. @param view The view. */
static bool is_due(const View *view) {
    bool is_later = play_has_time(view) && play_time(view) != view->time;
    return is_later || view->is_outdated || view->next_path[0] != '\0';
}

/**
 * Asks for the scene that is wanted.
 * @param[in,out] view  The view.
 * @param now           Now, seconds.
 * @param[out] error    What is wrong.
 * @return false if there is nobody to ask.
 */
static bool ask(View *view, double now, Error *error) {
    bool is_other = view->next_path[0] != '\0';
    ViewRequest request = {.path = is_other ? view->next_path : NULL,
                           .time = is_other ? 0 : play_time(view),
                           .is_anew = view->is_outdated};
    ReloadPicture pictures[RELOAD_PICTURES] = {0};
    for (size_t i = 0; i < stage_sights(&view->stage); i++) {
        Sight *sight = &view->stage.sights[i];
        pictures[i] = (ReloadPicture){.former = sight->renderer, .tuning = sight->tuning};
        sight->is_tuned = false;
    }
    bool is_asked = reloader_ask(&view->reloader, &request, pictures, error);
    view->next_time = now + PAUSE;
    view->is_outdated = false;
    view->next_path[0] = '\0';
    if (!is_asked) {
        view->timeline = (Timeline){.time = view->time};
    }
    return is_asked;
}

bool scenes_update(View *view, double now, Error *error) {
    bool is_good = take(view, error);
    if (!is_good || !is_due(view) || scenes_delay(view, now) > 0) {
        return is_good;
    }
    return ask(view, now, error);
}

double scenes_delay(View *view, double now) {
    bool is_asking = (play_has_time(view) && view->timeline.is_running) || is_due(view);
    // An answer may have come while the picture before was not on screen yet: nothing tells again.
    if (reloader_has_answer(&view->reloader) && stage_is_ready(&view->stage)) {
        return 0;
    }
    if (!is_asking || view->stage.is_hidden || reloader_is_busy(&view->reloader)) {
        return STAGE_NEVER;
    }
    return fmax(0, view->next_time - now);
}

void scenes_end(View *view) {
    watch_end(&view->watch);
    reloader_end(&view->reloader);
    scene_destroy(view->own_scene);
}
