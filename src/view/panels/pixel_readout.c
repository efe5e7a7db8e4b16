/**
 * @file
 * @brief Writing what the pixel under the mouse shows.
 */
#include "view/panels/pixel_readout.h"

#include <stdio.h>

/** Bytes of the readout with the final zero. */
enum { READOUT_SIZE = LAYER_TEXT_SIZE + 64 };

void pixel_readout_show(const Viewport *viewport, double right, double down, GuiPoint corner) {
    PixelReading reading;
    char text[READOUT_SIZE], value[LAYER_TEXT_SIZE] = "";
    int x = (int)(right * viewport->width), y = (int)(down * viewport->height);
    if (!viewport->renderer || !renderer_read_pixel(viewport->renderer, x, y, &reading)) {
        return;
    }
    if (reading.has_values) {
        layer_value_text(viewport->layer, reading.values, value);
    }
    const uint8_t *rgb = reading.rgb;
    snprintf(text, sizeof text, "%d, %d   %d %d %d%s%s", x, y, rgb[0], rgb[1], rgb[2],
             value[0] != '\0' ? "   " : "", value);
    gui_readout(text, rgb, corner);
}
