/**
 * @file
 * @brief The font of all panels.
 */
#ifndef DIOPTRE_VIEW_WINDOW_FONT_H
#define DIOPTRE_VIEW_WINDOW_FONT_H

#include <SDL_ttf.h>
#include <stdbool.h>

/** @return Whether a font is installed. */
bool font_is_available(void);

/** @return Path of an installed font with all letters; NULL: there is none. */
const char *font_path(void);

/** Opens the font. @return To be closed with #font_close; NULL: there is none. */
TTF_Font *font_open(void);

/** Closes the font. */
void font_close(TTF_Font *font);

/** @return Width of a text, pixels. */
int font_text_width(TTF_Font *font, const char *text);

/** Draws a text on a surface. @param text UTF-8; may be empty. */
void font_draw_text(SDL_Surface *panel, TTF_Font *font, const char *text, SDL_Color color, int x,
                    int y);

#endif
