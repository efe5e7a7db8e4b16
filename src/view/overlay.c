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
    PanelRoom room = overlay_room(screen);
    overlay_take(overlay, screen, panel_draw(rows, count, &room));
}

PanelRoom overlay_room(const OverlayScreen *screen) {
    PanelRoom room = {.scale = screen->scale};
    SDL_GetRendererOutputSize(screen->renderer, &room.width, &room.height);
    room.width = (int)(room.width * screen->share);
    return room;
}

void overlay_take(Overlay *overlay, const OverlayScreen *screen, SDL_Surface *panel) {
    overlay_forget(overlay);
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
    bool is_corner = overlay->place == OVERLAY_LEFT || overlay->place == OVERLAY_RIGHT;
    int right = width - place.w, below = height - place.h;
    place.x = !is_corner ? right / 2 : overlay->place == OVERLAY_LEFT ? 0 : right;
    place.y = is_corner ? 0 : overlay->place == OVERLAY_MIDDLE ? below / 2 : below;
    SDL_RenderCopy(screen->renderer, overlay->texture, NULL, &place);
}

void overlay_forget(Overlay *overlay) {
    if (overlay->texture) {
        SDL_DestroyTexture(overlay->texture);
        overlay->texture = NULL;
    }
}
