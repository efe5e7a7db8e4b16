/**
 * @file
 * @brief Placing the magnifier.
 */
#include "view/panels/magnifier.h"

#include <stddef.h>

void magnifier_toggle(Magnifier *magnifier) {
    *magnifier = (Magnifier){.is_on = !magnifier->is_on};
}

/** @return A coordinate inside the picture. @param size Pixels of the picture in that direction. */
static int clamp(int coordinate, int size) {
    return coordinate < 0 ? 0 : coordinate >= size ? size - 1 : coordinate;
}

void magnifier_follow(Magnifier *magnifier, const PixelPosition *mouse, int width, int height) {
    bool has_moved = mouse && (!magnifier->has_mouse || mouse->x != magnifier->mouse.x ||
                               mouse->y != magnifier->mouse.y);
    if (has_moved) {
        magnifier->pixel = magnifier->mouse = *mouse;
        magnifier->has_mouse = true;
    } else if (!magnifier->has_place) {
        magnifier->pixel = (PixelPosition){width / 2, height / 2};
    }
    magnifier->has_place = true;
    magnifier->pixel.x = clamp(magnifier->pixel.x, width);
    magnifier->pixel.y = clamp(magnifier->pixel.y, height);
}

void magnifier_step(Magnifier *magnifier, int right, int down) {
    magnifier->pixel.x += right;
    magnifier->pixel.y += down;
}
