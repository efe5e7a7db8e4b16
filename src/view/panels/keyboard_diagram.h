/**
 * @file
 * @brief A picture of the keyboard in use, with what its keys do.
 */
#ifndef DIOPTRE_VIEW_PANELS_KEYBOARD_DIAGRAM_H
#define DIOPTRE_VIEW_PANELS_KEYBOARD_DIAGRAM_H

#include <SDL.h>
#include <stdbool.h>

/** @return How large the picture is in a room: as wide as the room, unless that is flat; height 0
 *  where its keys would be too small to be read. */
SDL_Point keyboard_diagram_size(int width, int height);

/**
 * Draws the keyboard.
 * @param area  Which part of it, of the size that #keyboard_diagram_size says.
 * @param by_letter  Whether the light's keys go by their letters.
 */
void keyboard_diagram_draw(SDL_Surface *panel, const SDL_Rect *area, bool by_letter);

#endif
