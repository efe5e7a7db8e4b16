/**
 * @file
 * @brief What actions do to the view, whoever asks: a key, or a lesson.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_COMMANDS_H
#define DIOPTRE_VIEW_COMMANDS_COMMANDS_H

#include "view/app.h"
#include "view/commands/action.h"

/** Does what an action asks for. @param action What it asks for, not a move. */
void command_run(App *app, Action action);

#endif
