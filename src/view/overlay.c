/**
 * @file
 * @brief Panels as textures, and their places.
 */
#include "view/overlay.h"

bool overlay_is_stale(const Overlay *overlay) {
    return !overlay->texture;
}

void overlay_draw(Overlay *overlay, const OverlayScreen *screen, const PanelRow *rows,
                  size_t count) {
    PanelRoom room = {.scale = screen->scale};
    overlay_forget(overlay);
    SDL_GetRendererOutputSize(screen->renderer, &room.width, &room.height);
    SDL_Surface *panel = panel_draw(rows, count, &room);
    if (panel) {
        overlay->texture = SDL_CreateTextureFromSurface(screen->renderer, panel);
        SDL_FreeSurface(panel);
    }
}

void overlay_show(const Overlay *overlay, const OverlayScreen *screen) {
    SDL_Rect place = {0};
    int width = 0, height = 0;
    if (!overlay->texture) {
        return;
    }
    SDL_GetRendererOutputSize(screen->renderer, &width, &height);
    SDL_QueryTexture(overlay->texture, NULL, NULL, &place.w, &place.h);
    place.x = (width - place.w) / 2;
    place.y = overlay->place == OVERLAY_MIDDLE ? (height - place.h) / 2 : height - place.h;
    SDL_RenderCopy(screen->renderer, overlay->texture, NULL, &place);
}

void overlay_forget(Overlay *overlay) {
    if (overlay->texture) {
        SDL_DestroyTexture(overlay->texture);
        overlay->texture = NULL;
    }
}
