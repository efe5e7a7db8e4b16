/**
 * @file
 * @brief The names that lessons have for commands: moves first, then all others.
 */
#ifndef DIOPTRE_VIEW_LESSON_ACTION_NAMES_H
#define DIOPTRE_VIEW_LESSON_ACTION_NAMES_H

#include "view/state/command.h"

/** @return The command of a step of a lesson; NULL: there is none. @param action Index in the list
 *  of #view_actions. */
const Command *command_of_action(int action);

#endif
