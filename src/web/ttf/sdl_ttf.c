/**
 * @file
 * @brief Text by stb_truetype, which Dear ImGui brings along, behind SDL_ttf's functions.
 */
#include "SDL_ttf.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#pragma clang diagnostic push
#pragma clang diagnostic ignored "-Weverything"
#include <imstb_truetype.h>
#pragma clang diagnostic pop

struct TTF_Font {
    unsigned char *bytes; /**< The file; owned. */
    stbtt_fontinfo info;  /**< Its tables. */
    float scale;          /**< Pixels per unit of the font. */
    int ascent;           /**< Pixels above the baseline. */
    int line_skip;        /**< Pixels from one line to the next. */
};

int TTF_Init(void) {
    return 0;
}

void TTF_Quit(void) {}

int TTF_SetFontSize(TTF_Font *font, int size) {
    int ascent, descent, gap;
    font->scale = stbtt_ScaleForMappingEmToPixels(&font->info, (float)size);
    stbtt_GetFontVMetrics(&font->info, &ascent, &descent, &gap);
    font->ascent = (int)ceilf((float)ascent * font->scale);
    font->line_skip = (int)ceilf((float)(ascent - descent + gap) * font->scale);
    return 0;
}

TTF_Font *TTF_OpenFont(const char *path, int size) {
    FILE *file = fopen(path, "rb");
    TTF_Font *font = file ? calloc(1, sizeof *font) : NULL;
    if (font) {
        fseek(file, 0, SEEK_END);
        long length = ftell(file);
        rewind(file);
        font->bytes = malloc((size_t)length);
        bool is_read = font->bytes && fread(font->bytes, (size_t)length, 1, file) == 1 &&
                       stbtt_InitFont(&font->info, font->bytes, 0);
        if (is_read) {
            TTF_SetFontSize(font, size);
        } else {
            TTF_CloseFont(font);
            font = NULL;
        }
    }
    if (file) {
        fclose(file);
    }
    return font;
}

void TTF_CloseFont(TTF_Font *font) {
    if (font) {
        free(font->bytes);
        free(font);
    }
}

int TTF_FontLineSkip(const TTF_Font *font) {
    return font->line_skip;
}

/** Takes a letter off a text in UTF-8. @return Its number. */
static int next_letter(const char **text) {
    const unsigned char *c = (const unsigned char *)*text;
    int more = *c < 0xC0 ? 0 : *c < 0xE0 ? 1 : *c < 0xF0 ? 2 : 3;
    int letter = more ? *c & (0x3F >> more) : *c;
    for (c++; more > 0 && *c; more--, c++) {
        letter = letter << 6 | (*c & 0x3F);
    }
    *text = (const char *)c;
    return letter;
}

/** @return Width of a letter, pixels. */
static float advance_of(const TTF_Font *font, int letter) {
    int advance, bearing;
    stbtt_GetCodepointHMetrics(&font->info, letter, &advance, &bearing);
    return roundf((float)advance * font->scale);
}

int TTF_SizeUTF8(TTF_Font *font, const char *text, int *width, int *height) {
    float x = 0;
    while (*text) {
        x += advance_of(font, next_letter(&text));
    }
    if (width) {
        *width = (int)x;
    }
    if (height) {
        *height = font->line_skip;
    }
    return 0;
}

/** Draws a letter. @param left Its left end, pixels. */
static void draw_letter(TTF_Font *font, int letter, int left, Uint32 rgb, SDL_Surface *surface) {
    int width, height, x0, y0;
    unsigned char *coverage = stbtt_GetCodepointBitmap(&font->info, font->scale, font->scale,
                                                       letter, &width, &height, &x0, &y0);
    for (int y = 0; coverage && y < height; y++) {
        for (int x = 0; x < width; x++) {
            int to_x = left + x0 + x, to_y = font->ascent + y0 + y;
            if (to_x >= 0 && to_x < surface->w && to_y >= 0 && to_y < surface->h) {
                Uint32 *pixel = (Uint32 *)((Uint8 *)surface->pixels + to_y * surface->pitch) + to_x;
                Uint32 opacity = coverage[y * width + x];
                *pixel = rgb | (opacity > *pixel >> 24 ? opacity : *pixel >> 24) << 24;
            }
        }
    }
    stbtt_FreeBitmap(coverage, NULL);
}

SDL_Surface *TTF_RenderUTF8_Blended(TTF_Font *font, const char *text, SDL_Color color) {
    int width, height;
    TTF_SizeUTF8(font, text, &width, &height);
    SDL_Surface *surface =
        SDL_CreateRGBSurfaceWithFormat(0, width, height, 32, SDL_PIXELFORMAT_ARGB8888);
    Uint32 rgb = (Uint32)color.r << 16 | (Uint32)color.g << 8 | color.b;
    float x = 0;
    while (surface && *text) {
        int letter = next_letter(&text);
        draw_letter(font, letter, (int)x, rgb, surface);
        x += advance_of(font, letter);
    }
    return surface;
}
