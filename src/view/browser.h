/**
 * @file
 * @brief The list of scenes over the picture: small pictures of them, of which one is chosen.
 */
#ifndef DIOPTRE_VIEW_BROWSER_H
#define DIOPTRE_VIEW_BROWSER_H

#include "view/overlay.h"
#include "view/scene_list.h"

/** The list of scenes on screen. Starts as `{0}`: closed. */
typedef struct Browser {
    SceneList list; /**< The scenes. */
    bool is_open;   /**< Whether it is to be seen. */
    bool is_wanted; /**< Whether to fill it anew once the thread of the list before has ended. */
    bool is_placed; /**< Whether the scene that is shown was looked for in it. */
    char path[PATH_MAX]; /**< That scene's file. */
    size_t selected;     /**< Which scene is chosen. */
    size_t first_row;    /**< First row of pictures that is seen. */
    Overlay overlay;     /**< It as a picture. */
} Browser;

/** What became of a key or a click. */
typedef enum {
    BROWSER_STAYS,  /**< It is shown as before, or with another choice. */
    BROWSER_CLOSES, /**< It was closed. */
    BROWSER_OPENS   /**< The chosen scene is to be shown. */
} BrowserAnswer;

/** Opens it. @param[in,out] browser The list. @param settings How scenes are loaded. @param event
 *  SDL event, registered, that tells of news. @param path The scene that is shown. @return false if
 *  no thread could be started. */
bool browser_open(Browser *browser, const ViewSettings *settings, uint32_t event, const char *path);

/** Finds the scene that is shown among those that are found by now, once. @param[in,out] browser
 * The list. @param room The window. */
void browser_place(Browser *browser, const PanelRoom *room);

/** Closes it, without waiting. @param[in,out] browser The list. */
void browser_close(Browser *browser);

/** Ends it, before the window closes. @param[in,out] browser The list. */
void browser_end(Browser *browser);

/** Takes a key. @param[in,out] browser The list, open. @param key Which. @param room The window.
 *  @return What became of it. */
BrowserAnswer browser_key(Browser *browser, SDL_Keycode key, const PanelRoom *room);

/** Takes a click. @param[in,out] browser The list, open. @param x Pixels of the window. @param y
 *  Pixels. @param room The window. @return What became of it. */
BrowserAnswer browser_click(Browser *browser, int x, int y, const PanelRoom *room);

/** Goes some rows down. @param[in,out] browser The list, open. @param rows How many; below 0: up.
 *  @param room The window. */
void browser_scroll(Browser *browser, int rows, const PanelRoom *room);

/** @return Whether a scene is chosen. @param[in,out] browser The list. @param[out] path Its file.
 */
bool browser_choice(Browser *browser, char path[PATH_MAX]);

/** Lays it over what the window shows, if it is open. @param[in,out] browser The list, which keeps
 *  its picture. @param screen The window. */
void browser_show(Browser *browser, const OverlayScreen *screen);

#endif
