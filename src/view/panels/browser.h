/**
 * @file
 * @brief The list of scenes over the picture: thumbnails, of which one is selected.
 */
#ifndef DIOPTRE_VIEW_PANELS_BROWSER_H
#define DIOPTRE_VIEW_PANELS_BROWSER_H

#include "view/loading/scene_list.h"
#include "view/panels/panel.h"

/** The list of scenes. Starts as `{0}`: closed. */
typedef struct Browser {
    SceneList list;         /**< The scenes. */
    bool is_open;           /**< Whether it is shown. */
    bool is_reopen_pending; /**< Whether it is filled once the previous list's thread has ended. */
    bool is_current_selected; /**< Whether the scene on screen was searched in it. */
    char path[PATH_MAX];      /**< File of the scene on screen. */
    size_t selected;          /**< Index of the selected scene. */
    size_t first_row;         /**< First visible row. */
    Overlay overlay;          /**< Its panel. */
} Browser;

/** Result of a key or a click. */
typedef enum {
    BROWSER_KEEP_OPEN, /**< The list stays open. */
    BROWSER_CLOSE,     /**< The list is to be closed. */
    BROWSER_OPEN_SCENE /**< The selected scene is to be opened. */
} BrowserResult;

/** Opens the list. @param event See #scene_list_start. @param path File of the scene on screen.
 *  @return false if its thread cannot start. */
bool browser_open(Browser *browser, const ViewSettings *settings, uint32_t event, const char *path);

/** Selects the scene on screen, once, if it is in the list by now. */
void browser_select_current(Browser *browser, const PanelBounds *bounds);

/** Closes the list, without waiting for its thread. */
void browser_close(Browser *browser);

/** Frees the list; waits for its thread. */
void browser_deinit(Browser *browser);

/** Handles a key. */
BrowserResult browser_key(Browser *browser, SDL_Keycode key, const PanelBounds *bounds);

/** Handles a click. @param x Pixels of the window. */
BrowserResult browser_click(Browser *browser, int x, int y, const PanelBounds *bounds);

/** Selects the scene some rows below. @param rows Negative: above. */
void browser_scroll(Browser *browser, int rows, const PanelBounds *bounds);

/** @return Whether a scene is selected. @param[out] path Its file. */
bool browser_selected_path(Browser *browser, char path[PATH_MAX]);

/** Shows the list over the picture, if it is open. */
void browser_show(Browser *browser, const OverlayTarget *target);

/* --- its layout ------------------------------------------------------------------------------- */

/** The layout of the thumbnails. All lengths are pixels. */
typedef struct BrowserGrid {
    int columns;   /**< Thumbnails per row. */
    int rows;      /**< Visible rows. */
    int width;     /**< Width of a thumbnail with its border. */
    int height;    /**< Height of a thumbnail with its name. */
    int font_size; /**< Size of the letters. */
    int left;      /**< Left end of the first column. */
    int top;       /**< Top of the first row. */
} BrowserGrid;

/** @return The layout in a window. */
BrowserGrid browser_panel_grid(const PanelBounds *bounds);

/** @return The list as a panel that fills the window, owned by the caller; NULL without font or
 *  memory. The list must be locked. */
SDL_Surface *browser_panel_draw(const Browser *browser, const PanelBounds *bounds);

#endif
