/**
 * @file
 * @brief The scene's time in the window: held, stepped, or running in real time.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_TIME_CONTROL_H
#define DIOPTRE_VIEW_COMMANDS_TIME_CONTROL_H

#include "view/app.h"

/** @return Now on the clock that the scene's time goes by, seconds: a lesson's, or
 *  #clock_now_seconds. */
double time_control_clock(const App *app);

/** @return The scene's time as it should be now, seconds. */
double time_control_scene_time(const App *app);

/** @return Whether the scene asks what time it is. */
bool time_control_is_animated(const App *app);

/** Holds the time, or lets it run; says so where the scene asks for none. */
void time_control_toggle(App *app);

/** Steps the time, and holds it. @param steps How many steps; below 0: back. */
void time_control_step(App *app, int steps);

/** @return Whether the time stands still, and the scene is of that time. */
bool time_control_is_settled(const App *app);

#endif
