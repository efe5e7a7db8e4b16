/**
 * @file
 * @brief The list of scenes as a picture: where each stands, and drawing it.
 */
#ifndef DIOPTRE_VIEW_BROWSER_PANEL_H
#define DIOPTRE_VIEW_BROWSER_PANEL_H

#include "view/browser.h"

/** Where the small pictures stand. All lengths are pixels. */
typedef struct BrowserGrid {
    int columns; /**< How many side by side. */
    int rows;    /**< How many rows of them are seen. */
    int width;   /**< Of a picture with its border. */
    int height;  /**< Of a picture with its name. */
    int letters; /**< Size of the letters. */
    int left;    /**< Where the first column begins. */
    int top;     /**< Where the first row begins. */
} BrowserGrid;

/** @return Where the pictures stand in a window. @param room The window. */
BrowserGrid browser_grid(const PanelRoom *room);

/** @return The list as a picture that fills the window, to be freed by the caller; NULL without
 * font or memory. @param browser The list, locked. @param room The window. */
SDL_Surface *browser_draw(const Browser *browser, const PanelRoom *room);

#endif
