/**
 * @file
 * @brief The scene's time in the window.
 */
#include "view/play.h"

bool play_has_time(const View *view) {
    return view->settings->load && view->scene->reads_time;
}

/** Says that there is no time. @param[in,out] view The view. */
static void note_no_time(View *view) {
    view_note(view, "this scene does not ask for the time t");
}

void play_toggle(View *view) {
    if (!play_has_time(view)) {
        note_no_time(view);
    } else if (view->timeline.is_running) {
        timeline_hold(&view->timeline, stage_clock());
    } else {
        timeline_run(&view->timeline, stage_clock());
    }
    view->title_due = 0;
}

void play_step(View *view, int steps) {
    if (play_has_time(view)) {
        timeline_step(&view->timeline, steps, stage_clock());
    } else {
        note_no_time(view);
    }
}

bool play_is_at_rest(const View *view) {
    return !view->timeline.is_running && view->timeline.time == view->time;
}
