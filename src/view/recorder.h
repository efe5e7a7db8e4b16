/**
 * @file
 * @brief A lesson that is recorded: what is done in the window, as text of a lesson file.
 *
 * A recording begins at the scene's own view. While it lasts, light and camera move on the beats of
 * its clock, as they will when it is played.
 */
#ifndef DIOPTRE_VIEW_RECORDER_H
#define DIOPTRE_VIEW_RECORDER_H

#include "dioptre/error.h"
#include "view/action.h"
#include "view/metronome.h"

#include <SDL.h>
#include <stddef.h>
#include <stdio.h>

/** All that an open window knows; see state.h. */
typedef struct View View;

/** Bytes of a caption that is typed, with the final zero. */
enum { TYPED_SIZE = 512 };

/** A lesson that is recorded. Starts as `{0}`: none is. */
typedef struct Recorder {
    FILE *stream;           /**< Where its text goes: to memory; NULL: nothing is recorded. */
    char *text;             /**< Its text; owned. */
    size_t size;            /**< Bytes of it. */
    Metronome metronome;    /**< Its clock. */
    int64_t written;        /**< When the last step was, milliseconds. */
    double began;           /**< When its clock was at 0, on #clock_seconds. */
    bool is_typing;         /**< Whether a caption is typed: its clock stands still. */
    char typed[TYPED_SIZE]; /**< What was typed of it, UTF-8. */
} Recorder;

/** @return Whether a lesson is recorded. @param view The view. */
bool recorder_is_on(const View *view);

/** Begins to record, or ends it and writes the file. @param[in,out] view The view.
 *  @param[out] error What is wrong. @return Whether all is well. */
bool recorder_toggle(View *view, Error *error);

/** Ends a recording, if there is one, and writes the file. @param[in,out] view The view.
 *  @param[out] error What is wrong. @return Whether all is well. */
bool recorder_end(View *view, Error *error);

/** Moves what keys move up to now. @param[in,out] view The view. @param now Now, on #clock_seconds.
 */
void recorder_update(View *view, double now);

/** @return How long nothing is due, seconds, see #stage_delay. @param view The view. @param now
 *  Now, on #clock_seconds. */
double recorder_delay(const View *view, double now);

/** A key goes down. Only if a lesson is recorded. @param[in,out] view The view. @param action What
 *  it asks for; one that is no move is done by who calls. @param time When, on #clock_seconds. */
void recorder_press(View *view, Action action, double time);

/** A move's key goes up. Only if a lesson is recorded. @param[in,out] view The view. @param action
 *  The move. @param time When, on #clock_seconds. */
void recorder_release(View *view, Action action, double time);

/** No key is held any more. Only if a lesson is recorded. @param[in,out] view The view. @param time
 *  When, on #clock_seconds. */
void recorder_release_all(View *view, double time);

/** Moves go faster or slower. Only if a lesson is recorded. @param[in,out] view The view.
 *  @param speed Factor. @param time When, on #clock_seconds. */
void recorder_set_speed(View *view, double speed, double time);

/** Notes a step with numbers: `turn`, `zoom` or `size`. Nothing unless a lesson is recorded.
 *  @param[in,out] view The view. @param words The step, as in a lesson file. */
void recorder_note(View *view, const char *words);

/** Begins to type a caption. @param[in,out] view The view. */
void recorder_begin_caption(View *view);

/** Takes an event while a caption is typed. @param[in,out] view The view. @param event The event.
 *  @return Whether it was meant for the caption. */
bool recorder_types(View *view, const SDL_Event *event);

#endif
