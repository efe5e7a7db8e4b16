/**
 * @file
 * @brief Finding the font, and drawing text with SDL_ttf.
 */
#include "view/window/font.h"

#include <unistd.h>

/** Size of letters until another is set, pixels. */
static const int DEFAULT_FONT_SIZE = 12;

/** Fonts with all letters and arrows, where distributions install them. */
static const char *const font_paths[] = {
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

const char *font_path(void) {
    for (size_t i = 0; i < sizeof font_paths / sizeof font_paths[0]; i++) {
        if (access(font_paths[i], R_OK) == 0) {
            return font_paths[i];
        }
    }
    return NULL;
}

int font_text_width(TTF_Font *font, const char *text) {
    int width = 0;
    TTF_SizeUTF8(font, text, &width, NULL);
    return width;
}

TTF_Font *font_open(void) {
    const char *path = font_path();
    if (!path || TTF_Init() != 0) {
        return NULL;
    }
    TTF_Font *font = TTF_OpenFont(path, DEFAULT_FONT_SIZE);
    if (!font) {
        TTF_Quit();
    }
    return font;
}

void font_close(TTF_Font *font) {
    TTF_CloseFont(font);
    TTF_Quit();
}

void font_draw_text(SDL_Surface *panel, TTF_Font *font, const char *text, SDL_Color color, int x,
                    int y) {
    SDL_Surface *rendered = text[0] != '\0' ? TTF_RenderUTF8_Blended(font, text, color) : NULL;
    if (rendered) {
        SDL_Rect destination = {.x = x, .y = y};
        SDL_BlitSurface(rendered, NULL, panel, &destination);
        SDL_FreeSurface(rendered);
    }
}

bool font_is_available(void) {
    return font_path() != NULL;
}
