/**
 * @file
 * @brief Plays a lesson: the steps of its file issue commands.
 *
 * Space pauses and resumes it. While it is paused, the viewer may move camera and lights; they are
 * put back when it resumes. With a folder for snapshots it plays unattended: it saves the finished
 * picture at each caption and never waits, and the window closes at its end.
 */
#ifndef DIOPTRE_VIEW_LESSON_PLAYER_H
#define DIOPTRE_VIEW_LESSON_PLAYER_H

#include "view/app.h"
#include "view/state/command.h"

/** Begins the lesson that the window was opened with, if any. */
void player_begin(App *app);

/** Ends the lesson, if any. */
void player_end(App *app);

/** Does the steps that are due. */
void player_update(App *app, double now);

/** @return Seconds until the next step or tick; see #window_timeout. */
double player_timeout(const App *app, double now);

/** Saves the picture if the lesson waits for it and it is finished. @return false if it could not
 *  be saved: the window closes. */
bool player_capture(App *app, Error *error);

/** Handles a command of the viewer while a lesson plays. @param command The command; NULL: the key
 *  has none. @return Whether it is handled: it paused or resumed the lesson, or is not allowed. */
bool player_handle_command(App *app, const Command *command);

/** @return Whether the viewer may move things with the mouse. */
bool player_allows_input(const App *app);

#endif
