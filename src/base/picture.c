/**
 * @file
 * @brief Memory of pictures.
 */
#include "base/picture.h"

#include <stdlib.h>

/** Channels of a pixel. */
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

bool picture_allocate_linear(Picture *picture, Error *error) {
    size_t row = (size_t)picture->width * CHANNELS * sizeof *picture->linear;
    picture->linear = calloc((size_t)picture->height, row);
    return picture->linear ||
           error_set(error, STATUS_FAILED, "no memory for the light of a picture of %d x %d pixels",
                     picture->width, picture->height);
}

void picture_deinit(Picture *picture) {
    free(picture->pixels);
    free(picture->linear);
    *picture = (Picture){0};
}
