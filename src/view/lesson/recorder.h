/**
 * @file
 * @brief A lesson that is recorded: what is done in the window, as text of a lesson file.
 *
 * A recording begins at the scene's own view. While it lasts, light and camera move on the beats of
 * its clock, as they will when it is played.
 */
#ifndef DIOPTRE_VIEW_LESSON_RECORDER_H
#define DIOPTRE_VIEW_LESSON_RECORDER_H

#include "dioptre/error.h"
#include "view/commands/action.h"
#include "view/lesson/step_clock.h"

#include <SDL.h>
#include <stddef.h>
#include <stdio.h>

/** All that an open window knows; see state.h. */
typedef struct App App;

/** Bytes of a caption that is typed, with the final zero. */
enum { CAPTION_INPUT_SIZE = 512 };

/** A lesson that is recorded. Starts as `{0}`: none is. */
typedef struct Recorder {
    FILE *stream;             /**< Where its text goes: to memory; NULL: nothing is recorded. */
    char *text;               /**< Its text; owned. */
    size_t size;              /**< Bytes of it. */
    StepClock step_clock;     /**< Its clock. */
    int64_t last_step_time;   /**< When the last step was, milliseconds. */
    double start_time;        /**< When its clock was at 0, on #clock_now_seconds. */
    bool is_entering_caption; /**< Whether a caption is typed: its clock stands still. */
    char caption[CAPTION_INPUT_SIZE]; /**< What was typed of it, UTF-8. */
} Recorder;

/** @return Whether a lesson is recorded. */
bool recorder_is_active(const App *app);

/** Begins to record, or ends it and writes the file. @return Whether all is well. */
bool recorder_toggle(App *app, Error *error);

/** Ends a recording, if there is one, and writes the file. @return Whether all is well. */
bool recorder_end(App *app, Error *error);

/** Moves what keys move up to now. */
void recorder_update(App *app, double now);

/** @return How long nothing is due, seconds, see #window_timeout. */
double recorder_timeout(const App *app, double now);

/** A key goes down. Only if a lesson is recorded. @param action What it asks for; one that is no
 *  move is done by who calls. */
void recorder_press(App *app, Action action, double time);

/** A move's key goes up. Only if a lesson is recorded. */
void recorder_release(App *app, Action action, double time);

/** No key is held any more. Only if a lesson is recorded. */
void recorder_release_all(App *app, double time);

/** Moves go faster or slower. Only if a lesson is recorded. */
void recorder_set_speed(App *app, double speed, double time);

/** Notes a step with numbers: `turn`, `zoom` or `size`. Nothing unless a lesson is recorded. @param
 *  step The step, as in a lesson file. */
void recorder_record_step(App *app, const char *step);

/** Begins to type a caption. */
void caption_input_begin(App *app);

/** Takes an event while a caption is typed. @return Whether it was meant for the caption. */
bool caption_input_handle(App *app, const SDL_Event *event);

#endif
