/**
 * @file
 * @brief Choosing another scene from the list of scenes.
 */
#ifndef DIOPTRE_VIEW_INPUT_BROWSER_INPUT_H
#define DIOPTRE_VIEW_INPUT_BROWSER_INPUT_H

#include "view/app.h"

/** Opens the list of scenes. */
void browser_input_open(App *app);

/** Takes an event while the list is open. @return Whether it was meant for the list. */
bool browser_input_handle(App *app, const SDL_Event *event);

/** There is news in the list. */
void browser_input_on_list_changed(App *app);

#endif
