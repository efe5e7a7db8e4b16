/**
 * @file
 * @brief The list of lessons and scenes over the picture: thumbnails, of which one is selected.
 */
#ifndef DIOPTRE_VIEW_PANELS_BROWSER_H
#define DIOPTRE_VIEW_PANELS_BROWSER_H

#include "view/gui/gui.h"
#include "view/loading/scene_list.h"

/** Bytes of the words that are searched, with the final zero. */
enum { BROWSER_FILTER_SIZE = 64 };

/** A part of the list. */
typedef enum {
    BROWSER_LESSONS, /**< The lessons: the first part. */
    BROWSER_SCENES   /**< The scenes. */
} BrowserPart;

/** The list of scenes. Starts as `{0}`: closed. */
typedef struct Browser {
    SceneList list;         /**< The scenes. */
    bool is_open;           /**< Whether it is shown. */
    bool is_reopen_pending; /**< Whether it is filled once the previous list's thread has ended. */
    bool has_selection;     /**< Whether one was selected: by a key, or the first time. */
    bool begins_at_top;     /**< Whether the first time the first lesson is selected. */
    bool opens_first; /**< Whether what is selected the first time is opened: Enter came before. */
    char path[PATH_MAX];              /**< File of the scene on screen. */
    size_t selected;                  /**< Index of the selected scene. */
    char filter[BROWSER_FILTER_SIZE]; /**< Only scenes with these words are shown; empty: all. */
    bool scrolls;                     /**< Whether the next frame scrolls to the selected scene. */
    bool is_requested;       /**< Whether the selected scene is to be opened: by a click, or see
                                #opens_first. */
    bool is_close_requested; /**< Whether the button that closes the list was clicked. */
    bool follows_mouse;      /**< Whether the mouse was moved after the last key. */
    size_t described; /**< Index of the scene whose title is shown: the one under the mouse if it
                           was moved last, else the selected one. */
    int columns;      /**< Thumbnails per line in the last frame; 0: none yet. */
    SDL_Texture *textures[SCENE_LIST_MAXIMUM]; /**< The thumbnails; NULL: not yet; owned. */
} Browser;

/** Result of a key. */
typedef enum {
    BROWSER_KEEP_OPEN, /**< The list stays open. */
    BROWSER_CLOSE,     /**< The list is to be closed. */
    BROWSER_OPEN_SCENE /**< The selected scene is to be opened. */
} BrowserResult;

/** Opens the list. @param event See #scene_list_start. @param path File of the scene on screen.
 *  @return false if its thread cannot start. */
bool browser_open(Browser *browser, const ViewSettings *settings, uint32_t event, const char *path);

/** Selects the scene on screen, else the first one, once all scenes were found. Does nothing if one
 *  was selected before. */
void browser_select_current(Browser *browser);

/** Selects the first lesson, not the scene on screen. */
void browser_begin_at_top(Browser *browser);

/** Closes the list, without waiting for its thread. */
void browser_close(Browser *browser);

/** Frees the list; waits for its thread. */
void browser_deinit(Browser *browser);

/** Handles a key. */
BrowserResult browser_key(Browser *browser, SDL_Keycode key);

/** Takes the last word away that was typed. */
void browser_erase_word(Browser *browser);

/** Selects the first scene of a part, else of the other one, and scrolls to it. */
void browser_go_to(Browser *browser, BrowserPart part);

/** Adds what is typed to the words that are searched. @param text UTF-8. */
void browser_type(Browser *browser, const char *text);

/** @return Whether a scene is selected. @param[out] path Its file. */
bool browser_selected_path(Browser *browser, char path[PATH_MAX]);

/** Shows the list, if it is open. @param room The part of the window that it fills. */
void browser_show(Browser *browser, SDL_Renderer *renderer, const GuiRect *room);

/** Frees the thumbnails' textures: the graphics device was reset, or the list is closed. */
void browser_release_textures(Browser *browser);

/* --- which scenes are shown ------------------------------------------------------------------- */

/** The scenes that are shown, lessons first. */
typedef struct BrowserOrder {
    size_t indices[SCENE_LIST_MAXIMUM]; /**< Their indices in the list. */
    size_t lessons;                     /**< Number of lessons. */
    size_t count;                       /**< Number of lessons and scenes. */
} BrowserOrder;

/** Finds the scenes that are shown. The list must be locked. */
void browser_order(const Browser *browser, BrowserOrder *order);

/** @return The part in which the selected scene is. */
BrowserPart browser_part(const Browser *browser, const BrowserOrder *order);

#endif
