/**
 * @file
 * @brief Formats of picture files: which ending means which.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_FORMAT_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_FORMAT_H

#include "base/language.h"

#include <stdbool.h>

/** A format, as the ending of a file's name says it. */
typedef struct ImageFormat {
    const char *extension;   /**< In small letters, without the dot. */
    const char *plugin_name; /**< What the module calls it; NULL: BMP, which needs no module. */
    bool is_linear;          /**< Whether it holds linear light and not 8-bit steps. */
    bool is_read_only;       /**< Whether it is never written. */
} ImageFormat;

/** All endings of pictures that can be written, in words. */
#define IMAGE_WRITE_EXTENSIONS N_("bmp, png, exr, jpg, jpeg, tif, tiff or hdr")
/** All endings of pictures that can be read, in words. */
#define IMAGE_READ_EXTENSIONS N_("bmp, png, exr, jpg, jpeg, tif, tiff, hdr, ppm, pgm or pnm")

/** @return The format of BMP files, which needs no module. */
const ImageFormat *image_format_bmp(void);

/** Finds the format that the ending of a file's name says; small and large letters are alike.
 *  @return The format, or NULL. */
const ImageFormat *image_format_by_extension(const char *path);

#endif
