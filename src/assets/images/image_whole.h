/**
 * @file
 * @brief Whether a picture file is whole.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_WHOLE_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_WHOLE_H

#include <stdbool.h>
#include <sys/types.h>

/**
 * Checks whether a picture file is there and whole. BMP: the header promises no more bytes than
 * there are. PNG: its chunks fill the file and end with IEND. JPEG: it ends with its end marker.
 * All other formats are decoded, in a worker.
 * @param path  The file; its extension names the format.
 * @return Whether it is; false also where it cannot be opened, or has no known extension.
 */
bool image_file_is_whole(const char *path);

/** @return Whether the chunks of a PNG file fill it and end with IEND (ISO/IEC 15948, 5.3). See
 *          #ImageFormat.is_whole. */
bool image_png_is_whole(int file, off_t size);

/** @return Whether a JPEG file begins and ends with its markers (ITU-T T.81, B.1.1.3). See
 *          #ImageFormat.is_whole. */
bool image_jpeg_is_whole(int file, off_t size);

#endif
