/**
 * @file
 * @brief BMP pictures, written and read without a library.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_BMP_H
#define DIOPTRE_ASSETS_IMAGES_BMP_H

#include "base/picture.h"

#include <stdio.h>

/**
 * Writes a picture as BMP: a header of 54 bytes, then blue, green and red of each pixel, the lowest
 * row first.
 * @param picture     The picture, at most `IMAGE_SIZE_MAXIMUM` pixels wide and high.
 * @param stream      The output; need not be seekable.
 * @param[out] error  What is wrong (#STATUS_FAILED), without the path.
 * @return Whether all was written to the stream; closing it can still fail.
 */
bool bmp_write(const Picture *picture, FILE *stream, Error *error);

/**
 * @return Whether a file is a BMP file that #bmp_read can read and that has all its pixels, by its
 *         header and its size.
 * @param file  Descriptor of the file; it stays open.
 * @param size  Its size, bytes.
 */
bool bmp_is_whole(int file, off_t size);

/**
 * Reads an uncompressed BMP file of 24 or 32 bits per pixel, in either order of rows. The header is
 * checked against the file size before any allocation. The fourth byte per pixel, opacity in some
 * programs, is ignored.
 * @param file          Descriptor of the file; it stays open.
 * @param[out] picture  The picture, to be freed with #picture_deinit; empty on errors.
 * @param[out] error    What is wrong (#STATUS_SCENE), without the path.
 * @return Whether it was read.
 */
bool bmp_read(int file, Picture *picture, Error *error);

#endif
