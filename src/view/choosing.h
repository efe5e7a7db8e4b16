/**
 * @file
 * @brief Choosing another scene from the list of scenes.
 */
#ifndef DIOPTRE_VIEW_CHOOSING_H
#define DIOPTRE_VIEW_CHOOSING_H

#include "view/state.h"

/** Opens the list of scenes. @param[in,out] view The view. */
void choosing_begin(View *view);

/** Takes an event while the list is open. @param[in,out] view The view. @param event The event.
 *  @return Whether it was meant for the list. */
bool choosing_takes(View *view, const SDL_Event *event);

/** There is news in the list. @param[in,out] view The view. */
void choosing_on_news(View *view);

#endif
