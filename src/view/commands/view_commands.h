/**
 * @file
 * @brief What keys do to the pictures: layers, settings, two of them side by side.
 */
#ifndef DIOPTRE_VIEW_COMMANDS_VIEW_COMMANDS_H
#define DIOPTRE_VIEW_COMMANDS_VIEW_COMMANDS_H

#include "view/app.h"

/** Does what is asked of the pictures. @param action What; others are passed over. */
void view_commands_run(App *app, Action action);

#endif
