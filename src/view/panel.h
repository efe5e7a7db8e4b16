/**
 * @file
 * @brief Words over the picture: a dark panel with rows of them.
 */
#ifndef DIOPTRE_VIEW_PANEL_H
#define DIOPTRE_VIEW_PANEL_H

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
} PanelRow;

/** The room that a panel has. */
typedef struct PanelRoom {
    int width;    /**< Pixels of the window. */
    int height;   /**< Pixels of the window. */
    double scale; /**< How many times as large as usual letters shall be. */
} PanelRoom;

/** @return Whether there is a font to draw with. */
bool panel_is_possible(void);

/**
 * Draws a panel, in letters that the last row of a class can read if there is room for them.
 * @param rows   The rows.
 * @param count  How many, at least 1.
 * @param room   The room.
 * @return The panel, no larger than the window unless that is tiny; to be freed by the caller.
 *         NULL without font or memory.
 */
SDL_Surface *panel_draw(const PanelRow *rows, size_t count, const PanelRoom *room);

#endif
