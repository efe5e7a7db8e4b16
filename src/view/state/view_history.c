/**
 * @file
 * @brief The list of moves of camera and lights, and of choices.
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

void view_history_on_edits_cleared(ViewHistory *history) {
    for (size_t i = 0; i < history->count; i++) {
        history->steps[i].edits = 0;
    }
}

void view_history_rebase(ViewHistory *history, const RenderSettings *from,
                         const RenderSettings *to) {
    for (size_t i = 0; i < history->count; i++) {
        for (size_t j = 0; history->steps[i].is_choice && j < CHOICE_PICTURES; j++) {
            settings_override_rebase(&history->steps[i].choice.overrides[j], from, to);
        }
    }
}

/** @return The last step, if nothing is undone and no edit came after it; NULL: none. */
static const ViewStep *last_step(const ViewHistory *history, size_t edits) {
    const ViewStep *last = history->done > 0 ? &history->steps[history->done - 1] : NULL;
    return last && history->done == history->count && last->edits == edits ? last : NULL;
}

/** Forgets what is undone, and the oldest step where there is no room for another one. */
static void make_room(ViewHistory *history) {
    view_history_forget_undone(history);
    if (history->count == VIEW_STEPS_MAXIMUM) {
        view_state_deinit(&history->steps[0].view);
        memmove(history->steps, history->steps + 1, --history->count * sizeof history->steps[0]);
    }
}

void view_history_note(ViewHistory *history, const ViewState *home, const Scene *scene,
                       const ViewStep *step, double now) {
    const ViewStep *last = last_step(history, step->edits);
    bool continues = history->last_time > 0 && now - history->last_time < GROUP_SECONDS && last &&
                     !last->is_choice && last->subject == step->subject;
    history->last_time = now;
    if (continues) {
        return;
    }
    make_room(history);
    ViewStep noted = {.edits = step->edits, .subject = step->subject};
    if (view_state_save_current(&noted.view, home, scene, NULL)) {
        history->steps[history->count++] = noted;
    }
    history->done = history->count;
}

void view_history_note_choice(ViewHistory *history, const PictureChoice *before, size_t edits,
                              bool continues) {
    const ViewStep *last = last_step(history, edits);
    if (continues && last && last->is_choice) {
        return;
    }
    make_room(history);
    history->steps[history->count++] =
        (ViewStep){.is_choice = true, .choice = *before, .edits = edits};
    history->done = history->count;
}

/** Exchanges the present view or choice with that of a step. @return false without memory. */
static bool swap_step(ViewStep *step, const ViewTarget *target) {
    ViewState present;
    if (step->is_choice) {
        const PictureChoice chosen = *target->choice;
        *target->choice = step->choice;
        step->choice = chosen;
        return true;
    }
    if (!view_state_save_current(&present, target->home, target->scene, NULL)) {
        return false;
    }
    view_state_restore_current(&step->view, target->home, target->scene);
    view_state_deinit(&step->view);
    step->view = present;
    return true;
}

const ViewStep *view_history_undo(ViewHistory *history, const ViewTarget *target, size_t edits) {
    ViewStep *last = history->done > 0 ? &history->steps[history->done - 1] : NULL;
    if (!last || last->edits != edits || !swap_step(last, target)) {
        return NULL;
    }
    history->done--;
    history->last_time = 0;
    return last;
}

const ViewStep *view_history_redo(ViewHistory *history, const ViewTarget *target, size_t edits) {
    ViewStep *next = history->done < history->count ? &history->steps[history->done] : NULL;
    if (!next || next->edits != edits || !swap_step(next, target)) {
        return NULL;
    }
    history->done++;
    history->last_time = 0;
    return next;
}
