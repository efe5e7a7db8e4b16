/**
 * @file
 * @brief Panels: dark boxes with rows of text over the picture, and their textures.
 */
#ifndef DIOPTRE_VIEW_PANELS_PANEL_H
#define DIOPTRE_VIEW_PANELS_PANEL_H

#include <SDL.h>
#include <stdbool.h>

/** Bytes of a row's label; SDL's longest key name is below 20. */
enum { PANEL_LABEL_SIZE = 64 };

/** One row of a panel: a heading, or a label and a text. */
typedef struct PanelRow {
    bool is_heading;              /**< Whether it is the heading of a group. */
    char label[PANEL_LABEL_SIZE]; /**< Such as the name of a key, UTF-8; empty in a heading. */
    const char *text;             /**< Its text, UTF-8; not owned. */
    bool has_swatch;              /**< Whether the label's column shows a colour swatch. */
    uint8_t swatch[3];            /**< The colour, sRGB. */
    int tint;                     /**< Colour of heading or label, from 1; 0: the default. */
} PanelRow;

/** The space for a panel. */
typedef struct PanelBounds {
    int width;    /**< Pixels. */
    int height;   /**< Pixels. */
    double scale; /**< Factor of the size of letters. */
} PanelBounds;

/** @return The colour of a tint. @param tint #PanelRow.tint, at least 1. */
SDL_Color panel_tint_color(int tint);

/** @return An empty panel, owned by the caller; NULL without memory. */
SDL_Surface *panel_create(int width, int height);

/** @return Size of the largest letters with which a panel fits, pixels; 0 without font. */
int panel_font_size(const PanelRow *rows, size_t count, const PanelBounds *bounds);

/** Draws a panel. @param count At least 1. @param size Size of the letters, pixels. @return See
 *  #panel_draw. */
SDL_Surface *panel_draw_at_size(const PanelRow *rows, size_t count, int size);

/**
 * Draws a panel in letters that can be read from the last row of a class, where they fit.
 * @param count  At least 1.
 * @return The panel, no larger than the bounds unless they are tiny; owned by the caller. NULL
 *         without font or memory.
 */
SDL_Surface *panel_draw(const PanelRow *rows, size_t count, const PanelBounds *bounds);

/**
 * Breaks a text into rows, at spaces and line ends.
 * @param[in,out] text  UTF-8; each row is ended by a zero.
 * @param characters  Most characters of a row, unless a word is longer.
 * @param maximum  Most rows; the rest of the text is left out.
 * @return Number of rows.
 */
size_t word_wrap(char *text, int characters, PanelRow *rows, size_t maximum);

/* --- panels as textures ----------------------------------------------------------------------- */

/** Where a panel lies in a window. */
typedef enum {
    OVERLAY_CENTER,   /**< In the middle. */
    OVERLAY_BOTTOM,   /**< At the lower edge, in the middle. */
    OVERLAY_TOP_LEFT, /**< In the upper left corner. */
    OVERLAY_TOP_RIGHT /**< In the upper right corner. */
} OverlayAnchor;

/** A panel as a texture, kept until it is invalidated. Starts as `{.anchor = ...}`. */
typedef struct Overlay {
    OverlayAnchor anchor; /**< Where it lies. */
    SDL_Texture *texture; /**< The panel; NULL: it must be drawn; owned. */
} Overlay;

/** Where overlays are drawn. */
typedef struct OverlayTarget {
    SDL_Renderer *renderer; /**< Renderer of the window. */
    double scale;           /**< See #PanelBounds.scale. */
    double width_fraction;  /**< Fraction of the window's width for a panel. */
    int top;                /**< Height of the bar at the upper edge, pixels: panels are below. */
} OverlayTarget;

/** @return Whether the panel must be drawn before it can be shown. */
bool overlay_is_stale(const Overlay *overlay);

/** Draws the panel. */
void overlay_draw(Overlay *overlay, const OverlayTarget *target, const PanelRow *rows,
                  size_t count);

/** Takes a panel that is drawn. @param panel The panel, freed here; NULL: none. */
void overlay_set_surface(Overlay *overlay, const OverlayTarget *target, SDL_Surface *panel);

/** @return The space for a panel in a window. */
PanelBounds overlay_bounds(const OverlayTarget *target);

/** Shows the panel over the picture, if there is one. */
void overlay_show(const Overlay *overlay, const OverlayTarget *target);

/** Frees the texture: text, size or keyboard have changed, the graphics device was reset, or the
 *  window closes. */
void overlay_invalidate(Overlay *overlay);

#endif
