/**
 * @file
 * @brief The list of moves of camera and lights.
 */
#include "view/state/view_history.h"

#include <string.h>

/** Seconds within which a move belongs to the one before: longer than from key to key. */
static const double GROUP_SECONDS = 0.5;

void view_history_forget_undone(ViewHistory *history) {
    while (history->count > history->done) {
        view_state_deinit(&history->steps[--history->count].view);
    }
}

void view_history_clear(ViewHistory *history) {
    history->done = 0;
    history->last_time = 0;
    view_history_forget_undone(history);
}

void view_history_note(ViewHistory *history, const ViewState *home, const Scene *scene,
                       const ViewStep *step, double now) {
    const ViewStep *last = history->done > 0 ? &history->steps[history->done - 1] : NULL;
    bool continues = history->last_time > 0 && now - history->last_time < GROUP_SECONDS &&
                     history->done == history->count && last && last->edits == step->edits &&
                     last->subject == step->subject;
    history->last_time = now;
    if (continues) {
        return;
    }
    view_history_forget_undone(history);
    if (history->count == VIEW_STEPS_MAXIMUM) {
        view_state_deinit(&history->steps[0].view);
        memmove(history->steps, history->steps + 1, --history->count * sizeof history->steps[0]);
    }
    ViewStep noted = {.edits = step->edits, .subject = step->subject};
    if (view_state_save_current(&noted.view, home, scene, NULL)) {
        history->steps[history->count++] = noted;
    }
    history->done = history->count;
}

/** Changes the view with that of a step. @return false without memory. */
static bool swap_view(ViewStep *step, ViewState *home, Scene *scene) {
    ViewState present;
    if (!view_state_save_current(&present, home, scene, NULL)) {
        return false;
    }
    view_state_restore_current(&step->view, home, scene);
    view_state_deinit(&step->view);
    step->view = present;
    return true;
}

bool view_history_undo(ViewHistory *history, ViewState *home, Scene *scene, size_t edits) {
    bool is_last = history->done > 0 && history->steps[history->done - 1].edits == edits;
    if (!is_last || !swap_view(&history->steps[history->done - 1], home, scene)) {
        return false;
    }
    history->done--;
    history->last_time = 0;
    return true;
}

bool view_history_redo(ViewHistory *history, ViewState *home, Scene *scene, size_t edits) {
    bool is_next = history->done < history->count && history->steps[history->done].edits == edits;
    if (!is_next || !swap_view(&history->steps[history->done], home, scene)) {
        return false;
    }
    history->done++;
    history->last_time = 0;
    return true;
}
