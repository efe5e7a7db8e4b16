/**
 * @file
 * @brief The functions of SDL_ttf that the panels use, over stb_truetype (sdl_ttf.c).
 */
#ifndef DIOPTRE_WEB_SDL_TTF_H
#define DIOPTRE_WEB_SDL_TTF_H

#include <SDL.h>

/** A font. */
typedef struct TTF_Font TTF_Font;

/** Starts the library. @return 0 */
int TTF_Init(void);
/** Ends the library. */
void TTF_Quit(void);
/** Opens a font file. @return The font; NULL on errors. */
TTF_Font *TTF_OpenFont(const char *path, int size);
/** Closes a font. */
void TTF_CloseFont(TTF_Font *font);
/** Sets the size, pixels. @return 0 */
int TTF_SetFontSize(TTF_Font *font, int size);
/** @return Height of a line, pixels. */
int TTF_FontLineSkip(const TTF_Font *font);
/** Measures a text. @return 0 */
int TTF_SizeUTF8(TTF_Font *font, const char *text, int *width, int *height);
/** Draws a text. @return A surface with opacity; NULL on errors. */
SDL_Surface *TTF_RenderUTF8_Blended(TTF_Font *font, const char *text, SDL_Color color);

#endif
