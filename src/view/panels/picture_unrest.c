/**
 * @file
 * @brief The variance of a part of the picture.
 */
#include "view/panels/picture_unrest.h"

/** Columns and rows of pixels that are looked at: their cost is below a tenth of a millisecond. */
enum { COLUMNS = 16, ROWS = 16 };

/** @return The brightness of a pixel, 0 to 1020; 0 outside of the picture. @param right Fraction of
 *  its width. @param down Fraction of its height. */
static double brightness_at(const Viewport *viewport, double right, double down) {
    uint8_t rgb[3] = {0};
    renderer_copy_part(viewport->renderer, (int)floor(right * viewport->width),
                       (int)floor(down * viewport->height), 1, 1, rgb);
    return rgb[0] + 2 * rgb[1] + rgb[2];
}

double picture_unrest(const Viewport *viewport, const PicturePart *part) {
    const int count = COLUMNS * ROWS;
    double sum = 0, squares = 0;
    for (int i = 0; viewport->renderer && i < count; i++) {
        double across = (i % COLUMNS + 0.5) / COLUMNS, down = (i / COLUMNS + 0.5) / ROWS;
        double brightness =
            brightness_at(viewport, part->left + (part->right - part->left) * across,
                          part->top + (part->bottom - part->top) * down);
        sum += brightness;
        squares += brightness * brightness;
    }
    return squares / count - sum / count * (sum / count);
}
