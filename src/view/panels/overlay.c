/**
 * @file
 * @brief Panels as textures, and their places.
 */
#include "view/panels/overlay.h"

bool overlay_is_stale(const Overlay *overlay) {
    return !overlay->texture;
}

void overlay_draw(Overlay *overlay, const OverlayTarget *target, const PanelRow *rows,
                  size_t count) {
    PanelBounds bounds = overlay_bounds(target);
    overlay_set_surface(overlay, target, panel_draw(rows, count, &bounds));
}

PanelBounds overlay_bounds(const OverlayTarget *target) {
    PanelBounds bounds = {.scale = target->scale};
    SDL_GetRendererOutputSize(target->renderer, &bounds.width, &bounds.height);
    bounds.width = (int)(bounds.width * target->width_fraction);
    return bounds;
}

void overlay_set_surface(Overlay *overlay, const OverlayTarget *target, SDL_Surface *panel) {
    overlay_invalidate(overlay);
    if (panel) {
        overlay->texture = SDL_CreateTextureFromSurface(target->renderer, panel);
        SDL_FreeSurface(panel);
    }
}

void overlay_show(const Overlay *overlay, const OverlayTarget *target) {
    SDL_Rect destination = {0};
    int width = 0, height = 0;
    if (!overlay->texture) {
        return;
    }
    SDL_GetRendererOutputSize(target->renderer, &width, &height);
    SDL_QueryTexture(overlay->texture, NULL, NULL, &destination.w, &destination.h);
    bool is_corner = overlay->anchor == OVERLAY_TOP_LEFT || overlay->anchor == OVERLAY_TOP_RIGHT;
    int right = width - destination.w, below = height - destination.h;
    destination.x = !is_corner ? right / 2 : overlay->anchor == OVERLAY_TOP_LEFT ? 0 : right;
    destination.y = is_corner ? 0 : overlay->anchor == OVERLAY_CENTER ? below / 2 : below;
    SDL_RenderCopy(target->renderer, overlay->texture, NULL, &destination);
}

void overlay_invalidate(Overlay *overlay) {
    if (overlay->texture) {
        SDL_DestroyTexture(overlay->texture);
        overlay->texture = NULL;
    }
}
