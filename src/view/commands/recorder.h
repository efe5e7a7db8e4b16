/**
 * @file
 * @brief Records a lesson: what the viewer does in the window, as text of a lesson file.
 *
 * The recorder observes: #command_issue notifies it of each command, the input of everything else.
 * A recording begins at the scene's own view. While it lasts, light and camera move at the ticks of
 * its clock, as they do when the lesson plays.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_RECORDER_H
#define DIOPTRE_VIEW_COMMANDS_RECORDER_H

#include "view/app.h"
#include "view/state/command.h"

/** Begins to record. @return Whether it has begun. */
bool recorder_begin(App *app, Error *error);

/** Ends a recording and writes its file; does nothing without one. @return Whether it is written.
 */
bool recorder_end(App *app, Error *error);

/** Does the ticks up to now. */
void recorder_update(App *app, double now);

/** @return Seconds until the next tick; see #window_timeout. */
double recorder_timeout(const App *app, double now);

/** A command is about to run, or its move begins. @param time When its key went down, seconds.
 *  @param continues Whether undo takes the change before it back, too. */
void recorder_on_command(App *app, const Command *command, double time, bool continues);

/** The key of a move goes up. */
void recorder_on_release(App *app, const Command *command, double time);

/** All keys go up. */
void recorder_on_release_all(App *app, double time);

/** The speed of moves changes. */
void recorder_on_speed(App *app, double speed, double time);

/** Records a step with numbers: `turn`, `zoom`, `size` and so on. @param format The step as in a
 *  lesson file, as for printf. */
void recorder_on_step(App *app, const char *format, ...) __attribute__((format(printf, 2, 3)));

/** Starts the input of a caption; the recorder's clock is paused meanwhile. */
void recorder_begin_caption(App *app);

/** Accepts the caption that is typed; does nothing without one. */
void recorder_accept_caption(App *app);

/** Handles an event while a caption is typed. @return Whether it was for the caption. */
bool recorder_handle_caption_event(App *app, const SDL_Event *event);

/* --- the text of lessons ---------------------------------------------------------------------- */

/** Writes how long nothing happens. @param milliseconds How long; 0: nothing is written. */
void lesson_writer_wait(FILE *file, int64_t milliseconds);

/**
 * Finds a path as seen from a folder.
 * @param folder    The folder, absolute, without a slash at its end.
 * @param path      The path, absolute; both without links and dots.
 * @param[out] out  The relative path; the absolute one where only the root is common.
 * @param size      Bytes of it.
 */
void lesson_writer_relative_path(const char *folder, const char *path, char *out, size_t size);

/** Writes a caption as a step. @param[out] step The step, cut to its size. */
void lesson_writer_caption(char *step, size_t size, const char *caption);

#endif
