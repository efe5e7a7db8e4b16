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

#endif
