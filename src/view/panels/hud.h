/**
 * @file
 * @brief What is said beside a picture: how it is drawn, what that costs, what its colours mean.
 */
#ifndef DIOPTRE_VIEW_PANELS_HUD_H
#define DIOPTRE_VIEW_PANELS_HUD_H

#include "render/difference_map.h"
#include "view/panels/overlay.h"
#include "view/window/viewport.h"

/** Rows at most, and bytes of one. */
enum { HUD_ROWS = 28, HUD_TEXT_SIZE = 96 };

/** The panel beside a picture. Starts as `{.overlay = {.place = ...}}`. */
typedef struct Hud {
    Overlay overlay;                         /**< The panel. */
    PanelRow rows[HUD_ROWS];                 /**< What it says. */
    char row_texts[HUD_ROWS][HUD_TEXT_SIZE]; /**< The words of the rows. */
    size_t count;                            /**< How many rows. */
    double width_fraction;                   /**< Share of the window's width that it may take. */
    double next_update_time;                 /**< When it may say something else again, seconds. */
} Hud;

/** What there is to be said. */
typedef struct HudContent {
    const Viewport *viewport;        /**< Of which picture. */
    const char *title;               /**< What to call it, in English; NULL: there is only one. */
    bool shows_settings;             /**< Whether to say how it is drawn. */
    bool hides_layer;                /**< Whether the colours that are seen are not its layer's. */
    const DifferenceMap *difference; /**< What its difference to another is, where that is shown;
                                       else NULL. */
} HudContent;

/** Brings the words up to date, not too often: nobody reads so fast. @param content What there is
 *  to be said. */
void hud_update(Hud *hud, const HudContent *content, double now);

/** Shows it, if it has anything to say. */
void hud_show(Hud *hud, const OverlayTarget *target);

/** Words have changed, or the size of letters. */
void hud_invalidate(Hud *hud);

#endif
