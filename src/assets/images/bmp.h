/**
 * @file
 * @brief BMP pictures: written and read here, so that a snapshot needs no library.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_BMP_H
#define DIOPTRE_ASSETS_IMAGES_BMP_H

#include "base/picture.h"

#include <stdio.h>

/**
 * Writes a picture as BMP: a header of 54 bytes, then blue, green and red of each pixel, the lowest
 * row first.
 * @param picture     The picture, at most `IMAGE_SIZE_MAXIMUM` by as many pixels.
 * @param stream      Where to; need not be seekable.
 * @param[out] error  Why not (#STATUS_FAILED); the file is not named in it.
 * @return Whether all was handed to the stream; whether it arrives, closing the stream tells.
 */
bool bmp_write(const Picture *picture, FILE *stream, Error *error);

/**
 * Reads a BMP file of 24 or 32 bits a pixel, not compressed, of either order of rows. What its
 * header says is checked against the file's size before memory is taken or a pixel read. The
 * fourth byte of a pixel, opacity to some programs, is dropped.
 * @param file          The file, open; it stays so.
 * @param[out] picture  The picture; give it back with #picture_deinit.
 * @param[out] error    What is wrong (#STATUS_SCENE); the file is not named in it.
 * @return Whether it was read; otherwise the picture is empty.
 */
bool bmp_read(int file, Picture *picture, Error *error);

#endif
