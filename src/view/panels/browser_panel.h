/**
 * @file
 * @brief The list of scenes as a picture: where each stands, and drawing it.
 */
#ifndef DIOPTRE_VIEW_PANELS_BROWSER_PANEL_H
#define DIOPTRE_VIEW_PANELS_BROWSER_PANEL_H

#include "view/panels/browser.h"

/** Where the small pictures stand. All lengths are pixels. */
typedef struct BrowserGrid {
    int columns;   /**< How many side by side. */
    int rows;      /**< How many rows of them are seen. */
    int width;     /**< Of a picture with its border. */
    int height;    /**< Of a picture with its name. */
    int font_size; /**< Size of the letters. */
    int left;      /**< Where the first column begins. */
    int top;       /**< Where the first row begins. */
} BrowserGrid;

/** @return Where the pictures stand in a window. */
BrowserGrid browser_panel_grid(const PanelBounds *bounds);

/** @return The list as a picture that fills the window, to be freed by the caller; NULL without
 *  font or memory. */
SDL_Surface *browser_panel_draw(const Browser *browser, const PanelBounds *bounds);

#endif
