/**
 * @file
 * @brief What actions do to the view.
 */
#include "view/deeds.h"

#include "dioptre/language.h"
#include "view/choosing.h"
#include "view/pictures.h"
#include "view/play.h"
#include "view/recorder.h"
#include "view/scene_text.h"
#include "view/scenes.h"

#include <stdio.h>
#include <stdlib.h>

/** Shows the rays of one pixel, or the picture again. @param[in,out] view The view. */
static void toggle_rays(View *view) {
    inspector_toggle(&view->stage.inspector);
    stage_present(&view->stage);
}

/** Closes the window. @param[in,out] view The view. */
static void leave(View *view) {
    view->is_over = true;
}

/** Puts the scene's own view back. @param[in,out] view The view. */
static void go_home(View *view) {
    inspector_look_anew(&view->stage.inspector);
    pose_restore(&view->home, view->scene);
    view->light = 0;
    view_changed(view);
}

/** The light keys move the next light from now on. @param[in,out] view The view. */
static void select_next_light(View *view) {
    size_t count = view->scene->light_count;
    view->light = count > 0 ? (view->light + 1) % count : 0;
    if (count > 1) {
        view_hush(view);
    } else {
        view_note(view, count == 1 ? N_("there is one light") : N_("there is no light"));
    }
}

/** Opens or closes the help. @param[in,out] view The view. */
static void toggle_help(View *view) {
    if (!help_toggle(&view->stage.help)) {
        view_note(view, "no font found: the help is on standard output");
    }
    stage_present(&view->stage);
}

/** Speaks the other language. A scene that is wrong is read again, to say what is wrong in it.
 *  @param[in,out] view The view. */
static void switch_language(View *view) {
    language_switch();
    view_note(view, "messages are in English");
    scenes_repeat_error(view);
    stage_forget_words(&view->stage);
    stage_present(&view->stage);
}

/** Prints camera and lights as text of the scene language, and keeps it ready to be pasted.
 *  @param[in,out] view The view. */
static void copy_view(View *view) {
    char *text = scene_text_make(view->scene);
    if (!text) {
        view_note(view, "no memory for the view");
        return;
    }
    puts(text);
    fflush(stdout);
    bool is_copied = SDL_SetClipboardText(text) == 0;
    view_note(view, is_copied ? N_("camera and light can be pasted")
                              : N_("camera and light are printed"));
    free(text);
}

/**
 * Asks for a snapshot. It is of the finished picture: of the view as it is when that is there, so
 * the time is held.
 * @param[in,out] view  The view.
 */
static void ask_for_snapshot(View *view) {
    view->wants_snapshot = true;
    timeline_hold(&view->timeline, play_clock(view));
    view_note(view, "the snapshot waits for the last pass");
}

/** Begins to record a lesson, or ends it. @param[in,out] view The view. */
static void toggle_recording(View *view) {
    Error error = {0};
    if (!recorder_toggle(view, &error)) {
        view_report(view, &error);
    }
}

/** The time a step back. @param[in,out] view The view. */
static void step_back(View *view) {
    play_step(view, -1);
}

/** The time a step on. @param[in,out] view The view. */
static void step_on(View *view) {
    play_step(view, 1);
}

/** Larger letters. @param[in,out] view The view. */
static void enlarge_words(View *view) {
    stage_resize_words(&view->stage, 1);
}

/** Smaller letters. @param[in,out] view The view. */
static void shrink_words(View *view) {
    stage_resize_words(&view->stage, -1);
}

/** The whole screen, or a window again. @param[in,out] view The view. */
static void toggle_full_screen(View *view) {
    display_toggle_full_screen(&view->stage.display);
}

/** The numbers of the ray before. @param[in,out] view The view. */
static void choose_ray_before(View *view) {
    inspector_choose(&view->stage.inspector, -1);
}

/** The numbers of the next ray. @param[in,out] view The view. */
static void choose_next_ray(View *view) {
    inspector_choose(&view->stage.inspector, 1);
}

void deeds_do(View *view, Action action) {
    static void (*const deeds[])(View * view) = {[ACTION_SNAPSHOT] = ask_for_snapshot,
                                                 [ACTION_HOME] = go_home,
                                                 [ACTION_NEXT_LIGHT] = select_next_light,
                                                 [ACTION_TIME] = play_toggle,
                                                 [ACTION_TIME_BACK] = step_back,
                                                 [ACTION_TIME_ON] = step_on,
                                                 [ACTION_COPY] = copy_view,
                                                 [ACTION_TEXT_LARGER] = enlarge_words,
                                                 [ACTION_TEXT_SMALLER] = shrink_words,
                                                 [ACTION_LANGUAGE] = switch_language,
                                                 [ACTION_SCENES] = choosing_begin,
                                                 [ACTION_RECORD] = toggle_recording,
                                                 [ACTION_CAPTION] = recorder_begin_caption,
                                                 [ACTION_HELP] = toggle_help,
                                                 [ACTION_FULL_SCREEN] = toggle_full_screen,
                                                 [ACTION_RAYS] = toggle_rays,
                                                 [ACTION_RAY_BACK] = choose_ray_before,
                                                 [ACTION_RAY_ON] = choose_next_ray,
                                                 [ACTION_LEAVE] = leave,
                                                 [ACTION_NONE] = NULL};
    if (deeds[action]) {
        deeds[action](view);
    } else {
        pictures_act(view, action);
    }
}
