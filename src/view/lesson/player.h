/**
 * @file
 * @brief A lesson that is played in the window.
 *
 * Space holds it and lets it go on. Held, the window is the viewer's: camera and lights may be
 * moved, and are back when it goes on. With a folder for snapshots nobody is waited for: at each
 * caption the finished picture is kept, and the window closes at the end.
 */
#ifndef DIOPTRE_VIEW_LESSON_PLAYER_H
#define DIOPTRE_VIEW_LESSON_PLAYER_H

#include "dioptre/lesson.h"
#include "view/commands/timeline.h"
#include "view/commands/view_state.h"
#include "view/lesson/step_clock.h"

/** All that an open window knows; see state.h. */
typedef struct App App;

/** A lesson that is played. Starts as `{0}`: there is none. */
typedef struct Player {
    const Lesson *lesson;     /**< The lesson; NULL: none is played. */
    StepClock step_clock;     /**< Its clock. */
    size_t next_step;         /**< Its next step. */
    double start_time;        /**< When its clock was at 0, on #clock_now_seconds. */
    bool is_paused;           /**< Whether it waits for Space. */
    bool is_capturing;        /**< Whether it waits for the finished picture, to keep it. */
    ViewState paused_view;    /**< Camera and lights when it was held; owned. */
    size_t paused_light;      /**< The light that keys moved then. */
    Timeline paused_timeline; /**< The scene's time then. */
} Player;

/** Begins the lesson that the window was opened with, if it was. @param[in,out] app The view, with
 *  its scene. */
void player_begin(App *app);

/** @return Whether a lesson is played. */
bool player_is_active(const App *app);

/** @return Whether its clock stands still. */
bool player_is_clock_stopped(const Player *player);

/** Does what is due. */
void player_update(App *app, double now);

/** @return How long nothing is due, seconds, see #window_timeout. */
double player_timeout(const App *app, double now);

/** Keeps the picture if that is wanted and it is finished. @return false if it could not be kept:
 *  the window closes. */
bool player_capture(App *app, Error *error);

/** Answers a key before anybody else. @return Whether that was all: the key holds the lesson or
 *  lets it go on, or has no meaning now. */
bool player_handle_action(App *app, Action action);

/** @return Whether the mouse and moves are the viewer's now. */
bool player_allows_input(const App *app);

/** Ends the lesson, if there is one. */
void player_end(App *app);

#endif
