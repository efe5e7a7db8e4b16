/**
 * @file
 * @brief The scene's time in the window: it runs in real time, and what cannot be drawn is dropped.
 */
#ifndef DIOPTRE_VIEW_PLAY_H
#define DIOPTRE_VIEW_PLAY_H

#include "view/state.h"

/** Holds the time, or lets it run; says so where the scene asks for none. @param[in,out] view The
 *  view. */
void play_toggle(View *view);

/** Steps the time, and holds it. @param[in,out] view The view. @param steps How many steps; below
 * 0: back. */
void play_step(View *view, int steps);

/**
 * Shows the scene of the newest time, as soon as it is there and the one before is on screen.
 * @param[in,out] view  The view.
 * @param now           Now, seconds.
 * @param[out] error    What is wrong with the scene; the time is held then.
 * @return Whether all is well.
 */
bool play_update(View *view, double now, Error *error);

/** @return How long nothing is to be done, seconds, see #stage_delay. @param view The view. @param
 *  now Now, seconds. */
double play_delay(View *view, double now);

/** @return Whether the time is held, and the scene is of that time. @param view The view. */
bool play_is_at_rest(const View *view);

/** Gives all scenes of other times back; what the stage draws with must still be there.
 *  @param[in,out] view The view. */
void play_end(View *view);

#endif
