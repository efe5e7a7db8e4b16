/**
 * @file
 * @brief Drawing a frame of the interface.
 */
#ifndef DIOPTRE_VIEW_GUI_GUI_DRAW_H
#define DIOPTRE_VIEW_GUI_GUI_DRAW_H

#include <SDL.h>
#include <imgui.h>

/** A panel that is kept as a picture; a list of them. */
struct KeptPanel {
    KeptPanel *next;               /**< The next one; owned; null: none. */
    const ImDrawList *list;        /**< Whose picture it is; Dear ImGui has one for each panel. */
    ImVector<ImDrawVert> vertices; /**< What was drawn. */
    ImVector<ImDrawIdx> indices;   /**< The same. */
    ImVector<ImDrawCmd> commands;  /**< The same. */
    SDL_Rect rect;                 /**< Where it lies, pixels of the window. */
    SDL_Texture *picture;          /**< The picture; owned. */
    bool is_shown;                 /**< Whether the last frame has shown it. */
};

/** Draws what Dear ImGui has laid out. @param[in,out] kept The panels that are kept. */
void draw_frame(SDL_Renderer *renderer, const ImDrawData *data, KeptPanel **kept);

/** Frees the panels that are kept: their letters or the graphics device have changed. */
void forget_panels(KeptPanel **kept);

#endif
