/**
 * @file
 * @brief What keys, mouse and window do to the view.
 */
#ifndef DIOPTRE_VIEW_CONTROLS_H
#define DIOPTRE_VIEW_CONTROLS_H

#include "view/state.h"

/**
 * Does what an event asks for.
 * @param[in,out] view  The view.
 * @param event         The event.
 */
void controls_handle(View *view, const SDL_Event *event);

#endif
