/**
 * @file
 * @brief Formats of picture files by extension.
 */
#include "assets/images/image_format.h"

#include "assets/images/bmp.h"
#include "assets/images/image_whole.h"
#include "base/base_name.h"

#include <string.h>
#include <strings.h>

/**
 * All formats; an entry without extension ends the list. OpenImageIO supports many more. Targa is
 * excluded: its reader in OpenImageIO 2.4 has known vulnerabilities (CVE-2023-22845,
 * CVE-2023-24473).
 */
static const ImageFormat formats[] = {
    {.extension = "bmp", .is_whole = bmp_is_whole},
    {.extension = "png", .plugin_name = "png", .is_whole = image_png_is_whole},
    {.extension = "exr", .plugin_name = "openexr", .is_linear = true},
    {.extension = "jpg", .plugin_name = "jpeg", .is_whole = image_jpeg_is_whole},
    {.extension = "jpeg", .plugin_name = "jpeg", .is_whole = image_jpeg_is_whole},
    {.extension = "tif", .plugin_name = "tiff"},
    {.extension = "tiff", .plugin_name = "tiff"},
    {.extension = "hdr", .plugin_name = "hdr", .is_linear = true},
    {.extension = "ppm", .plugin_name = "pnm", .is_read_only = true},
    {.extension = "pgm", .plugin_name = "pnm", .is_read_only = true},
    {.extension = "pnm", .plugin_name = "pnm", .is_read_only = true},
    {0},
};

const ImageFormat *image_format_bmp(void) {
    return &formats[0];
}

const ImageFormat *image_format_by_extension(const char *path) {
    const char *dot = strrchr(base_name(path), '.');
    for (const ImageFormat *format = formats; dot && format->extension; format++) {
        if (strcasecmp(dot + 1, format->extension) == 0) {
            return format;
        }
    }
    return NULL;
}
