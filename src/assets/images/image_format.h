/**
 * @file
 * @brief Formats of picture files by extension.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_FORMAT_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_FORMAT_H

#include "base/language.h"

#include <stdbool.h>
#include <sys/types.h>

/** A format of picture files. */
typedef struct ImageFormat {
    const char *extension;   /**< Extension in lower case, without the dot. */
    const char *plugin_name; /**< Name in OpenImageIO; NULL: BMP, which needs no module. */
    bool is_linear;          /**< Whether it contains linear light instead of 8-bit codes. */
    bool is_read_only;       /**< Whether it is never written. */
    /**
     * Looks at the end of a file; NULL: only decoding tells.
     * @param file  Descriptor of the file.
     * @param size  Its size, bytes.
     * @return Whether the file is whole.
     */
    bool (*is_whole)(int file, off_t size);
} ImageFormat;

/** The extensions of the formats that can be written, for messages. */
#define IMAGE_WRITE_EXTENSIONS N_("bmp, png, exr, jpg, jpeg, tif, tiff or hdr")
/** The extensions of the formats that can be read, for messages. */
#define IMAGE_READ_EXTENSIONS N_("bmp, png, exr, jpg, jpeg, tif, tiff, hdr, ppm, pgm or pnm")

/** @return The format of BMP files, which needs no module. */
const ImageFormat *image_format_bmp(void);

/**
 * Finds the format of a file's extension, ignoring case.
 * @param path  The file.
 * @return The format; NULL: unknown.
 */
const ImageFormat *image_format_by_extension(const char *path);

#endif
