/**
 * @file
 * @brief Where camera and lights were before each of the user's moves, and what was chosen before
 *        each choice of settings, with undo and redo.
 *
 * Moves, choices and edits of objects (edit_history.h) are undone in the order in which they were
 * made: each step knows how many edits were in force. Without a screen.
 */
#ifndef DIOPTRE_VIEW_STATE_VIEW_HISTORY_H
#define DIOPTRE_VIEW_STATE_VIEW_HISTORY_H

#include "view/state/picture_choice.h"
#include "view/state/view_state.h"

/** Most steps that are kept; the oldest goes. */
enum { VIEW_STEPS_MAXIMUM = 64 };
/** The camera, or everything, as the subject of a move. */
#define VIEW_SUBJECT_ALL SIZE_MAX

/** One move, of a key that is held or of a drag; or one choice. */
typedef struct ViewStep {
    bool is_choice;       /**< Whether it is a choice. */
    ViewState view;       /**< Of a move: camera and lights before it; once it is undone, after it;
                               owned. */
    PictureChoice choice; /**< Of a choice: the one before it; once it is undone, it itself. */
    size_t edits;         /**< Number of edits that were in force. */
    size_t subject;       /**< Of a move: index of the light; #VIEW_SUBJECT_ALL: camera, or all. */
} ViewStep;

/** What undo and redo change. */
typedef struct ViewTarget {
    ViewState *home;       /**< The home view. */
    Scene *scene;          /**< Its camera and lights are moved. */
    PictureChoice *choice; /**< What is chosen. */
} ViewTarget;

/** Moves and choices. Starts as `{0}`: none. */
typedef struct ViewHistory {
    ViewStep steps[VIEW_STEPS_MAXIMUM]; /**< The steps, oldest first. */
    size_t count;                       /**< Their number. */
    size_t done;                        /**< Number of them in force; the others are undone. */
    double last_time;                   /**< When the last one went on, seconds; 0: it is over. */
} ViewHistory;

/** Forgets all steps. */
void view_history_clear(ViewHistory *history);

/** Forgets the steps that are undone: something else was changed. */
void view_history_forget_undone(ViewHistory *history);

/** All edits are forgotten: the steps stay without them. */
void view_history_on_edits_cleared(ViewHistory *history);

/** The settings without the user's changes are others now. See #settings_override_rebase. */
void view_history_rebase(ViewHistory *history, const RenderSettings *from,
                         const RenderSettings *to);

/**
 * Notes where camera and lights are, before they move. Moves of the same thing that follow within
 * half a second belong to the one before. Without memory, the move cannot be undone.
 * @param step  The move: edits in force and subject; its view is not looked at.
 * @param now   Seconds.
 */
void view_history_note(ViewHistory *history, const ViewState *home, const Scene *scene,
                       const ViewStep *step, double now);

/** Notes what was chosen, before it changes. @param edits Number of edits in force. @param
 * continues Whether it belongs to the choice before it. */
void view_history_note_choice(ViewHistory *history, const PictureChoice *before, size_t edits,
                              bool continues);

/** Takes a step back, or does it again. @return The step; NULL: there is none. */
typedef const ViewStep *ViewHistoryStepFn(ViewHistory *history, const ViewTarget *target,
                                          size_t edits);

/** Takes the last step back, if it was made after the last edit. See #ViewHistoryStepFn. */
const ViewStep *view_history_undo(ViewHistory *history, const ViewTarget *target, size_t edits);

/** Does the step again that was undone last, if it came before the next edit. See
 *  #ViewHistoryStepFn. */
const ViewStep *view_history_redo(ViewHistory *history, const ViewTarget *target, size_t edits);

#endif
