/**
 * @file
 * @brief The panel on a picture: its settings and its cost; and the title.
 */
#ifndef DIOPTRE_VIEW_PANELS_HUD_H
#define DIOPTRE_VIEW_PANELS_HUD_H

#include "view/gui/gui.h"
#include "view/window/viewport.h"

/** Most rows, and bytes of a row with the final zero. */
enum { HUD_ROWS = 28, HUD_TEXT_SIZE = 96 };

/** The panel on a picture. Starts as `{0}`. */
typedef struct Hud {
    GuiRow rows[HUD_ROWS];                   /**< Its rows. */
    char row_texts[HUD_ROWS][HUD_TEXT_SIZE]; /**< Texts of the rows. */
    size_t count;                            /**< Number of rows. */
    double next_update_time;                 /**< Earliest time of the next change, seconds. */
} Hud;

/** The content of the panel. */
typedef struct HudContent {
    const Viewport *viewport; /**< The picture. */
    const char *title;        /**< Its name, in English; NULL: there is only one picture. */
    bool shows_settings;      /**< Whether settings and cost are shown. */
} HudContent;

/** Updates the panel, at most a few times per second, so that it can be read. */
void hud_update(Hud *hud, const HudContent *content, double now);

/** Shows the panel, if it has rows. @param id Unique in the window. @return Where it lies. */
GuiRect hud_show(const Hud *hud, const char *id, const GuiPlace *place);

/** Has the panel written anew: the language has changed. */
void hud_invalidate(Hud *hud);

/* --- the window's title ----------------------------------------------------------------------- */

/** Longest title, bytes with the final zero; a longer one is cut. */
enum { TITLE_SIZE = 512 };

/** The content of the title. */
typedef struct TitleContent {
    const char *name;          /**< Name of the scene or the lesson. */
    int width;                 /**< Pixels of the picture. */
    int height;                /**< Pixels of the picture. */
    const RenderStats *report; /**< The newest pass; NULL: none yet. */
    const double *time;        /**< The scene's time, seconds; NULL: it does not depend on time. */
    bool is_running;           /**< Whether the time runs. */
    bool is_recording;         /**< Whether a lesson is recorded. */
    size_t light;              /**< Index of the selected light. */
    size_t light_count;        /**< Number of lights. */
    const char *status_text;   /**< The newest message; empty: none. */
    size_t room; /**< Letters that a title has room for; a longer one leaves out what the picture
                      costs. 0: any number. */
} TitleContent;

/** Writes the title. */
void title_write(const TitleContent *content, char title[TITLE_SIZE]);

#endif
