/**
 * @file
 * @brief Leaving a lesson or the program, with a question where something would be lost.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_LEAVING_H
#define DIOPTRE_VIEW_COMMANDS_LEAVING_H

#include "view/app.h"

/** Ends the lesson that plays, or else the program; if that would lose something, only when it is
 *  asked for a second time. */
void leaving_request(App *app);

/** The user goes on instead of answering whether to leave: the question is taken back, unless the
 *  command is one that leaves. @param command What is done now; NULL: nothing that has a name. */
void leaving_withdraw(App *app, const Command *command);

#endif
