/**
 * @file
 * @brief Letters for what lies over the picture.
 */
#ifndef DIOPTRE_VIEW_WINDOW_FONT_H
#define DIOPTRE_VIEW_WINDOW_FONT_H

#include <SDL_ttf.h>
#include <stdbool.h>

/** @return Whether there is a font to draw with. */
bool font_is_available(void);

/** Opens a font. @return It, to be closed with #font_close; NULL if there is none. */
TTF_Font *font_open(void);

/** Closes a font. */
void font_close(TTF_Font *font);

/** @return Width of a text, pixels. */
int font_text_width(TTF_Font *font, const char *text);

/** Writes a text on a surface. @param text UTF-8; nothing is written for an empty one. */
void font_draw_text(SDL_Surface *panel, TTF_Font *font, const char *text, SDL_Color color, int x,
                    int y);

#endif
