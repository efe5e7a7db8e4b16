/**
 * @file
 * @brief The window's icon.
 */
#ifndef DIOPTRE_VIEW_WINDOW_WINDOW_ICON_H
#define DIOPTRE_VIEW_WINDOW_WINDOW_ICON_H

#include <SDL.h>

/** @return The program's icon, to be freed with `SDL_FreeSurface`; NULL without memory. */
SDL_Surface *window_icon_create(void);

/** Gives a window the program's icon. Without memory it keeps the desktop's. */
void window_icon_set(SDL_Window *window);

#endif
