/**
 * @file
 * @brief Where camera and lights were before each of the user's moves, with undo and redo.
 *
 * Moves and edits of objects (edit_history.h) are undone in the order in which they were made: each
 * move knows how many edits were in force. Without a screen.
 */
#ifndef DIOPTRE_VIEW_STATE_VIEW_HISTORY_H
#define DIOPTRE_VIEW_STATE_VIEW_HISTORY_H

#include "view/state/view_state.h"

/** Most moves that are kept; the oldest goes. */
enum { VIEW_STEPS_MAXIMUM = 64 };
/** The camera, or everything, as the subject of a move. */
#define VIEW_SUBJECT_ALL SIZE_MAX

/** One move, of a key that is held or of a drag. */
typedef struct ViewStep {
    ViewState view; /**< Camera and lights before it; once it is undone, after it; owned. */
    size_t edits;   /**< Number of edits that were in force. */
    size_t subject; /**< Index of the light that was moved; #VIEW_SUBJECT_ALL: camera, or all. */
} ViewStep;

/** The moves. Starts as `{0}`: none. */
typedef struct ViewHistory {
    ViewStep steps[VIEW_STEPS_MAXIMUM]; /**< The moves, oldest first. */
    size_t count;                       /**< Their number. */
    size_t done;                        /**< Number of them in force; the others are undone. */
    double last_time;                   /**< When the last one went on, seconds; 0: it is over. */
} ViewHistory;

/** Forgets all moves. */
void view_history_clear(ViewHistory *history);

/** Forgets the moves that are undone: something else was changed. */
void view_history_forget_undone(ViewHistory *history);

/**
 * Notes where camera and lights are, before they move. Moves of the same thing that follow within
 * half a second belong to the one before. Without memory, the move cannot be undone.
 * @param step  The move: edits in force and subject; its view is not looked at.
 * @param now   Seconds.
 */
void view_history_note(ViewHistory *history, const ViewState *home, const Scene *scene,
                       const ViewStep *step, double now);

/** Takes the last move back, if it was made after the last edit. @return Whether it was. */
bool view_history_undo(ViewHistory *history, ViewState *home, Scene *scene, size_t edits);

/** Does the move again that was undone last, if it came before the next edit. @return Whether it
 *  did. */
bool view_history_redo(ViewHistory *history, ViewState *home, Scene *scene, size_t edits);

#endif
