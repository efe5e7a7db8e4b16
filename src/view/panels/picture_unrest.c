/**
 * @file
 * @brief The variance of a part of the picture.
 */
#include "view/panels/picture_unrest.h"

/** Columns and rows of pixels that are looked at: their cost is below a tenth of a millisecond. */
enum { COLUMNS = 32, ROWS = 8 };

double picture_unrest(const Viewport *viewport, double top, double bottom) {
    double sum = 0, squares = 0;
    int count = 0;
    for (int i = 0; viewport->renderer && i < COLUMNS * ROWS; i++) {
        double right = (i % COLUMNS + 0.5) / COLUMNS;
        double down = top + (bottom - top) * (i / COLUMNS + 0.5) / ROWS;
        PixelReading reading;
        if (renderer_read_pixel(viewport->renderer, (int)(right * viewport->width),
                                (int)(down * viewport->height), &reading)) {
            double brightness = reading.rgb[0] + 2 * reading.rgb[1] + reading.rgb[2];
            sum += brightness;
            squares += brightness * brightness;
            count++;
        }
    }
    return count > 0 ? squares / count - sum / count * (sum / count) : 0;
}
