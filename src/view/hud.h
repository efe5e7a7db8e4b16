/**
 * @file
 * @brief What is said beside a picture: how it is drawn, what that costs, what its colours mean.
 */
#ifndef DIOPTRE_VIEW_HUD_H
#define DIOPTRE_VIEW_HUD_H

#include "dioptre/difference.h"
#include "view/overlay.h"
#include "view/sight.h"

/** Rows at most, and bytes of one. */
enum { HUD_ROWS = 28, HUD_TEXT = 96 };

/** The panel beside a picture. Starts as `{.overlay = {.place = ...}}`. */
typedef struct Hud {
    Overlay overlay;                /**< The panel. */
    PanelRow rows[HUD_ROWS];        /**< What it says. */
    char texts[HUD_ROWS][HUD_TEXT]; /**< The words of the rows. */
    size_t count;                   /**< How many rows. */
    double share;                   /**< Share of the window's width that it may take. */
    double due;                     /**< When it may say something else again, seconds. */
} Hud;

/** What there is to be said. */
typedef struct HudFacts {
    const Sight *sight;           /**< Of which picture. */
    const char *title;            /**< What to call it, in English; NULL: there is only one. */
    bool has_settings;            /**< Whether to say how it is drawn. */
    bool hides_layer;             /**< Whether the colours that are seen are not its layer's. */
    const Difference *difference; /**< What its difference to another is, where that is shown; else
                                       NULL. */
} HudFacts;

/**
 * Brings the words up to date, not too often: nobody reads so fast.
 * @param[in,out] hud  The panel.
 * @param facts        What there is to be said.
 * @param now          Now, seconds.
 */
void hud_update(Hud *hud, const HudFacts *facts, double now);

/** Shows it, if it has anything to say. @param[in,out] hud The panel. @param screen The window. */
void hud_show(Hud *hud, const OverlayScreen *screen);

/** Words have changed, or the size of letters. @param[in,out] hud The panel. */
void hud_forget(Hud *hud);

#endif
