/**
 * @file
 * @brief The list of scenes over the picture: small pictures of them, of which one is chosen.
 */
#ifndef DIOPTRE_VIEW_PANELS_BROWSER_H
#define DIOPTRE_VIEW_PANELS_BROWSER_H

#include "view/loading/scene_list.h"
#include "view/panels/overlay.h"

/** The list of scenes on screen. Starts as `{0}`: closed. */
typedef struct Browser {
    SceneList list;           /**< The scenes. */
    bool is_open;             /**< Whether it is to be seen. */
    bool is_reopen_pending;   /**< Whether to fill it anew once the thread of the list before has
                                 ended. */
    bool is_current_selected; /**< Whether the scene that is shown was looked for in it. */
    char path[PATH_MAX];      /**< That scene's file. */
    size_t selected;          /**< Which scene is chosen. */
    size_t first_row;         /**< First row of pictures that is seen. */
    Overlay overlay;          /**< It as a picture. */
} Browser;

/** What became of a key or a click. */
typedef enum {
    BROWSER_KEEP_OPEN, /**< It is shown as before, or with another choice. */
    BROWSER_CLOSE,     /**< It was closed. */
    BROWSER_OPEN_SCENE /**< The chosen scene is to be shown. */
} BrowserResult;

/**
 * Opens it.
 * @param settings  How scenes are loaded.
 * @param event  SDL event, registered, that tells of news.
 * @param path  The scene that is shown.
 * @return false if no thread could be started.
 */
bool browser_open(Browser *browser, const ViewSettings *settings, uint32_t event, const char *path);

/** Finds the scene that is shown among those that are found by now, once. */
void browser_select_current(Browser *browser, const PanelBounds *bounds);

/** Closes it, without waiting. */
void browser_close(Browser *browser);

/** Ends it, before the window closes. */
void browser_deinit(Browser *browser);

/** Takes a key. @return What became of it. */
BrowserResult browser_key(Browser *browser, SDL_Keycode key, const PanelBounds *bounds);

/**
 * Takes a click.
 * @param x  Pixels of the window.
 * @return What became of it.
 */
BrowserResult browser_click(Browser *browser, int x, int y, const PanelBounds *bounds);

/** Goes some rows down. @param rows How many; below 0: up. */
void browser_scroll(Browser *browser, int rows, const PanelBounds *bounds);

/** @return Whether a scene is chosen. */
bool browser_selected_path(Browser *browser, char path[PATH_MAX]);

/** Lays it over what the window shows, if it is open. @param[in,out] browser The list, which keeps
 *  its picture. */
void browser_show(Browser *browser, const OverlayTarget *target);

#endif
