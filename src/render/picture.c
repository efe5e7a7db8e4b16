/**
 * @file
 * @brief Pictures: their memory.
 */
#include "dioptre/picture.h"

#include <stdlib.h>

/** Bytes a pixel: red, green, blue. */
enum { CHANNELS = 3 };

bool picture_init(Picture *picture, int width, int height, Error *error) {
    *picture = (Picture){0};
    uint8_t *pixels = calloc((size_t)height, (size_t)width * CHANNELS);
    if (!pixels) {
        return error_set(error, STATUS_FAILED, "no memory for a picture of %d x %d pixels", width,
                         height);
    }
    *picture =
        (Picture){.width = width, .height = height, .pixels = pixels, .encoding = ENCODING_SRGB};
    return true;
}

void picture_release(Picture *picture) {
    free(picture->pixels);
    *picture = (Picture){0};
}
