/**
 * @file
 * @brief Drawing the help.
 */
#ifndef DIOPTRE_VIEW_HELP_PANEL_H
#define DIOPTRE_VIEW_HELP_PANEL_H

#include <SDL.h>
#include <stdbool.h>

/** @return Whether there is a font to draw with. */
bool help_panel_is_possible(void);

/**
 * Draws the help for a window, with the keys of the keyboard in use.
 * @param by_letter  Whether the light's keys go by their letters.
 * @param width      Pixels of the window.
 * @param height     Pixels of the window.
 * @return The panel, no larger than the window unless that is tiny; to be freed by the caller.
 *         NULL without font or memory.
 */
SDL_Surface *help_panel_draw(bool by_letter, int width, int height);

#endif
