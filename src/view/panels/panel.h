/**
 * @file
 * @brief Words over the picture: a dark panel with rows of them.
 */
#ifndef DIOPTRE_VIEW_PANELS_PANEL_H
#define DIOPTRE_VIEW_PANELS_PANEL_H

#include <SDL.h>
#include <stdbool.h>

/** Bytes for the label of a row; the longest key name of SDL is below 20. */
enum { PANEL_LABEL_SIZE = 64 };

/** One row of a panel: a heading, or a label and what is said of it. */
typedef struct PanelRow {
    bool is_heading; /**< Whether this is the heading of a group. */
    char
        label[PANEL_LABEL_SIZE]; /**< Such as what is printed on keys, UTF-8; empty in a heading. */
    const char *text;            /**< What is said, UTF-8; owned by others. */
    bool has_swatch;             /**< Whether a colour is shown in the label's place. */
    uint8_t swatch[3];           /**< The colour, sRGB. */
    int tint;                    /**< Which colour heading or label have; 0: their usual one. */
} PanelRow;

/** The room that a panel has. */
typedef struct PanelBounds {
    int width;    /**< Pixels of the window. */
    int height;   /**< Pixels of the window. */
    double scale; /**< How many times as large as usual letters shall be. */
} PanelBounds;

/** @return The colour of a tint. @param tint #PanelRow.tint, above 0. */
SDL_Color panel_tint_color(int tint);

/** @return An empty panel, to be freed by the caller; NULL without memory. */
SDL_Surface *panel_create(int width, int height);

/** @return Size of the largest letters that a panel can have, pixels; 0 without font. */
int panel_font_size(const PanelRow *rows, size_t count, const PanelBounds *bounds);

/**
 * Draws a panel in letters of one size.
 * @param count  How many, at least 1.
 * @param size  Size of the letters, pixels.
 * @return See #panel_draw.
 */
SDL_Surface *panel_draw_at_size(const PanelRow *rows, size_t count, int size);

/**
 * Draws a panel, in letters that the last row of a class can read if there is room for them.
 * @param count  How many, at least 1.
 * @return The panel, no larger than the window unless that is tiny; to be freed by the caller. NULL
 *         without font or memory.
 */
SDL_Surface *panel_draw(const PanelRow *rows, size_t count, const PanelBounds *bounds);

#endif
