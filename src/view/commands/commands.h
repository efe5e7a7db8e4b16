/**
 * @file
 * @brief The commands of the window: one table, and running them.
 *
 * A new key is one row of #command_table and the function that it runs.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_COMMANDS_H
#define DIOPTRE_VIEW_COMMANDS_COMMANDS_H

#include "view/app.h"
#include "view/state/command.h"

/** All commands, in the order of the help; see #command_is_row for its end. */
extern const Command command_table[];

/** Runs a command that is no move: for a lesson that plays. @param continues Whether undo takes the
 *  change before it back, too. */
void command_run(App *app, const Command *command, bool continues);

/** Runs a command for the viewer, or begins its move; the recorder is notified first. @param time
 *  When its key went down, seconds on #clock_now_seconds. */
void command_issue(App *app, const Command *command, double time);

/** Issues a command by its name, now. */
void command_issue_named(App *app, const char *name);

/** The same, as a part of the change before it: of a key that is held, or a slider. */
void command_continue(App *app, const Command *command, double time);

/** Shows the rays of a pixel; the recorder is notified first. @param x Fraction of the picture's
 *  width. @param y Fraction of its height. */
void command_show_rays(App *app, double x, double y);

/** Chooses one of the rays that are shown; the recorder is notified first. */
void command_choose_ray(App *app, size_t ray);

#endif
