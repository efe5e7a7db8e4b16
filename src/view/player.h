/**
 * @file
 * @brief A lesson that is played in the window.
 *
 * Space holds it and lets it go on. Held, the window is the viewer's: camera and lights may be
 * moved, and are back when it goes on. With a folder for snapshots nobody is waited for: at each
 * caption the finished picture is kept, and the window closes at the end.
 */
#ifndef DIOPTRE_VIEW_PLAYER_H
#define DIOPTRE_VIEW_PLAYER_H

#include "dioptre/lesson.h"
#include "view/metronome.h"
#include "view/pose.h"
#include "view/timeline.h"

/** All that an open window knows; see state.h. */
typedef struct View View;

/** A lesson that is played. Starts as `{0}`: there is none. */
typedef struct Player {
    const Lesson *lesson; /**< The lesson; NULL: none is played. */
    Metronome metronome;  /**< Its clock. */
    size_t next;          /**< Its next step. */
    double began;         /**< When its clock was at 0, on #clock_seconds. */
    bool is_held;         /**< Whether it waits for Space. */
    bool is_shooting;     /**< Whether it waits for the finished picture, to keep it. */
    Pose kept;            /**< Camera and lights when it was held; owned. */
    size_t light;         /**< The light that keys moved then. */
    Timeline timeline;    /**< The scene's time then. */
} Player;

/** Begins the lesson that the window was opened with, if it was. @param[in,out] view The view, with
 *  its scene. */
void player_begin(View *view);

/** @return Whether a lesson is played. @param view The view. */
bool player_is_on(const View *view);

/** @return Whether its clock stands still. @param player The lesson. */
bool player_is_still(const Player *player);

/** Does what is due. @param[in,out] view The view. @param now Now, on #clock_seconds. */
void player_update(View *view, double now);

/** @return How long nothing is due, seconds, see #stage_delay. @param view The view. @param now
 *  Now, on #clock_seconds. */
double player_delay(const View *view, double now);

/** Keeps the picture if that is wanted and it is finished. @param[in,out] view The view.
 *  @param[out] error What is wrong. @return false if it could not be kept: the window closes. */
bool player_shoot(View *view, Error *error);

/**
 * Answers a key before anybody else.
 * @param[in,out] view  The view.
 * @param action        What it asks for.
 * @return Whether that was all: the key holds the lesson or lets it go on, or has no meaning now.
 */
bool player_takes(View *view, Action action);

/** @return Whether the mouse and moves are the viewer's now. @param view The view. */
bool player_leaves_view(const View *view);

/** Ends the lesson, if there is one. @param[in,out] view The view. */
void player_end(View *view);

#endif
