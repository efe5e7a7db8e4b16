/**
 * @file
 * @brief Formats of picture files: which ending means which.
 */
#include "assets/image_format.h"

#include "assets/place.h"

#include <string.h>
#include <strings.h>

/**
 * All formats; the last has no ending. OpenImageIO knows some hundred more. Targa is left out on
 * purpose: its reader in OpenImageIO 2.4 has known holes (CVE-2023-22845, CVE-2023-24473).
 */
static const ImageFormat formats[] = {
    {.ending = "bmp"},
    {.ending = "png", .module = "png"},
    {.ending = "exr", .module = "openexr", .is_linear = true},
    {.ending = "jpg", .module = "jpeg"},
    {.ending = "jpeg", .module = "jpeg"},
    {.ending = "tif", .module = "tiff"},
    {.ending = "tiff", .module = "tiff"},
    {.ending = "hdr", .module = "hdr", .is_linear = true},
    {.ending = "ppm", .module = "pnm", .is_read_only = true},
    {.ending = "pgm", .module = "pnm", .is_read_only = true},
    {.ending = "pnm", .module = "pnm", .is_read_only = true},
    {0},
};

const ImageFormat *image_format_bmp(void) {
    return &formats[0];
}

const ImageFormat *image_format_by_ending(const char *path) {
    const char *name = path + place_folder_length(path);
    const char *dot = strrchr(name, '.');
    for (const ImageFormat *format = formats; dot && format->ending; format++) {
        if (strcasecmp(dot + 1, format->ending) == 0) {
            return format;
        }
    }
    return NULL;
}
