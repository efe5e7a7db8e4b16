/**
 * @file
 * @brief Handles the events of keyboard, mouse and window.
 */
#ifndef DIOPTRE_VIEW_INPUT_INPUT_H
#define DIOPTRE_VIEW_INPUT_INPUT_H

#include "view/app.h"

/** Handles an event. */
void input_handle_event(App *app, const SDL_Event *event);

#endif
