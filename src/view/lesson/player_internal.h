/**
 * @file
 * @brief What the files of the player share.
 */
#ifndef DIOPTRE_VIEW_LESSON_PLAYER_INTERNAL_H
#define DIOPTRE_VIEW_LESSON_PLAYER_INTERNAL_H

#include "view/app.h"

/* --- player.c --------------------------------------------------------------------------------- */

/** Puts the lesson to its beginning. */
void player_rewind(App *app);

/** Does the steps to be repeated. */
void player_repeat_steps(App *app);

/* --- lesson_stops.c --------------------------------------------------------------------------- */

/** @return Whether the lesson plays without a viewer. */
bool player_is_unattended(const App *app);

/** @return Whether a step is a stop: a caption, a question, an explanation. */
bool player_is_stop(const LessonStep *step);

/** @return The next stop of the lesson; the number of its steps: there is none. */
size_t player_next_stop(const Player *player);

/** @return Whether the lesson runs, and stops next where a question is answered. */
bool player_is_before_verdict(const Player *player);

/** Shows in the panel what the lesson does. */
void player_update_panel(App *app);

/** Lets the clock run again. */
void player_resume_clock(Player *player);

/** Stops the lesson, and saves the view. @param state #PLAYER_WAITS or #PLAYER_ASKS. */
void player_stop(App *app, PlayerState state);

/** Restores the view, and lets the lesson go on. */
void player_resume(App *app);

/** Shows a caption, a question or an explanation, and stops if it waits. */
void player_show_stop(App *app, const LessonStep *step);

/** Takes an answer to the question on screen. @param answer The choice, from 1. @return Whether
 *  there is such a choice. */
bool player_answer(App *app, int answer);

#endif
