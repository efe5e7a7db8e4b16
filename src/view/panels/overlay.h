/**
 * @file
 * @brief A panel over the picture, kept as a texture until anything about it changes.
 */
#ifndef DIOPTRE_VIEW_PANELS_OVERLAY_H
#define DIOPTRE_VIEW_PANELS_OVERLAY_H

#include "view/panels/panel.h"

/** Where in a window a panel lies. */
typedef enum {
    OVERLAY_CENTER,   /**< In its middle. */
    OVERLAY_BOTTOM,   /**< At its lower edge, in the middle. */
    OVERLAY_TOP_LEFT, /**< In its upper left corner. */
    OVERLAY_TOP_RIGHT /**< In its upper right corner. */
} OverlayAnchor;

/** A panel over the picture. Starts as `{.place = ...}`. */
typedef struct Overlay {
    OverlayAnchor anchor; /**< Where it lies. */
    SDL_Texture *texture; /**< The panel; NULL: to be made when needed; owned. */
} Overlay;

/** What panels are drawn with. */
typedef struct OverlayTarget {
    SDL_Renderer *renderer; /**< What draws in the window. */
    double scale;           /**< See #PanelBounds.scale. */
    double width_fraction;  /**< Share of the window's width that a panel may take. */
} OverlayTarget;

/** @return Whether the panel must be drawn anew before it can be shown. */
bool overlay_is_stale(const Overlay *overlay);

/** Draws the panel anew. */
void overlay_draw(Overlay *overlay, const OverlayTarget *target, const PanelRow *rows,
                  size_t count);

/** Takes a panel that was drawn elsewhere. @param panel The panel; freed by this; NULL: there is
 *  none. */
void overlay_set_surface(Overlay *overlay, const OverlayTarget *target, SDL_Surface *panel);

/** @return The room that a panel has in a window. */
PanelBounds overlay_bounds(const OverlayTarget *target);

/** Lays the panel over what the window shows. @param overlay The overlay; nothing is laid where it
 *  could not be drawn. */
void overlay_show(const Overlay *overlay, const OverlayTarget *target);

/** Forgets the panel: what it says, the size or the keyboard have changed, or the graphics card
 *  lost it. To be called before the window closes, too. */
void overlay_invalidate(Overlay *overlay);

#endif
