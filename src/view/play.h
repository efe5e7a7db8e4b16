/**
 * @file
 * @brief The scene's time in the window: held, stepped, or running in real time.
 */
#ifndef DIOPTRE_VIEW_PLAY_H
#define DIOPTRE_VIEW_PLAY_H

#include "view/state.h"

/** @return Now on the clock that the scene's time goes by, seconds: a lesson's, or #clock_seconds.
 *  @param view The view. */
double play_clock(const View *view);

/** @return The scene's time as it should be now, seconds. @param view The view. */
double play_time(const View *view);

/** @return Whether the scene asks what time it is. @param view The view. */
bool play_has_time(const View *view);

/** Holds the time, or lets it run; says so where the scene asks for none. @param[in,out] view The
 *  view. */
void play_toggle(View *view);

/** Steps the time, and holds it. @param[in,out] view The view. @param steps How many steps; below
 * 0: back. */
void play_step(View *view, int steps);

/** @return Whether the time stands still, and the scene is of that time. @param view The view. */
bool play_is_at_rest(const View *view);

#endif
