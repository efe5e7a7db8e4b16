/**
 * @file
 * @brief Letters.
 */
#include "view/font.h"

#include <unistd.h>

/** Size of letters before any is asked for, pixels. */
static const int SIZE_FIRST = 12;

/** Fonts that have the letters and arrows, in the places where systems keep them. */
static const char *const fonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu/DejaVuSans.ttf",
    "/usr/local/share/fonts/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation2/LiberationSans-Regular.ttf",
    "/usr/share/fonts/liberation-sans/LiberationSans-Regular.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
};

/** @return Path of a font that is there, or NULL. */
static const char *find_font(void) {
    for (size_t i = 0; i < sizeof fonts / sizeof fonts[0]; i++) {
        if (access(fonts[i], R_OK) == 0) {
            return fonts[i];
        }
    }
    return NULL;
}

int font_width(TTF_Font *font, const char *text) {
    int width = 0;
    TTF_SizeUTF8(font, text, &width, NULL);
    return width;
}

TTF_Font *font_open(void) {
    const char *path = find_font();
    if (!path || TTF_Init() != 0) {
        return NULL;
    }
    TTF_Font *font = TTF_OpenFont(path, SIZE_FIRST);
    if (!font) {
        TTF_Quit();
    }
    return font;
}

void font_close(TTF_Font *font) {
    TTF_CloseFont(font);
    TTF_Quit();
}

void font_write(SDL_Surface *panel, TTF_Font *font, const char *text, SDL_Color color, int x,
                int y) {
    SDL_Surface *words = text[0] != '\0' ? TTF_RenderUTF8_Blended(font, text, color) : NULL;
    if (words) {
        SDL_Rect place = {.x = x, .y = y};
        SDL_BlitSurface(words, NULL, panel, &place);
        SDL_FreeSurface(words);
    }
}

bool font_is_there(void) {
    return find_font() != NULL;
}
