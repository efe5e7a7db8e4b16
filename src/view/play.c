/**
 * @file
 * @brief The scene's time in the window.
 */
#include "view/play.h"

double play_clock(const View *view) {
    if (player_is_on(view)) {
        return metronome_seconds(&view->player.metronome);
    }
    return recorder_is_on(view) ? metronome_seconds(&view->recorder.metronome) : clock_seconds();
}

double play_time(const View *view) {
    return timeline_at(&view->timeline, play_clock(view));
}

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
        timeline_hold(&view->timeline, play_clock(view));
    } else {
        timeline_run(&view->timeline, play_clock(view));
    }
    view->title_due = 0;
}

void play_step(View *view, int steps) {
    if (play_has_time(view)) {
        timeline_step(&view->timeline, steps, play_clock(view));
    } else {
        note_no_time(view);
    }
}

bool play_is_at_rest(const View *view) {
    bool is_still = !view->timeline.is_running || player_is_still(&view->player);
    return is_still && (!play_has_time(view) || play_time(view) == view->time);
}
