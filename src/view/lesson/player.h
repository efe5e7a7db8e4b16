/**
 * @file
 * @brief Plays a lesson: the steps of its file issue commands.
 *
 * Space pauses and resumes it. While it is paused, the viewer may move camera and lights; they are
 * put back when it resumes. At a question it waits for an answer, and shows the right one after the
 * steps that follow: predict, observe, explain (Crouch 2004). A step back puts everything to the
 * lesson's beginning, and repeats the steps without drawing; so the view is equal to the bit. With
 * a folder for snapshots it plays unattended: it saves the finished picture at each caption and
 * explanation and never waits, and the window closes at its end.
 */
#ifndef DIOPTRE_VIEW_LESSON_PLAYER_H
#define DIOPTRE_VIEW_LESSON_PLAYER_H

#include "view/app.h"
#include "view/state/command.h"

/** Begins the lesson that the window was opened with, if any. */
void player_begin(App *app);

/** Ends the lesson, if any. */
void player_end(App *app);

/** Ends the lesson as its viewer wishes, who then has the picture: says what to press there. */
void player_close(App *app);

/** Opens a scene or a lesson, unless a lesson plays. @param path Its file. */
void player_open_file(App *app, const char *path);

/** Opens what is selected in the list of scenes, and closes the list. */
void player_open_selected(App *app);

/** Does what a button of the lesson's panel has requested. */
void player_handle_request(App *app);

/** Handles the key of a digit: an answer, or a button of the end card. @return Whether it is one.
 */
bool player_handle_digit(App *app, SDL_Scancode key);

/** Begins the lesson that was loaded; does the steps that are due. */
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
