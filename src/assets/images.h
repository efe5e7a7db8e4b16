/**
 * @file
 * @brief Opens the picture module and moves pictures across its border.
 */
#ifndef ASSETS_IMAGES_H
#define ASSETS_IMAGES_H

#include "assets/images_module.h"
#include "dioptre/picture.h"

#include <stdio.h>

/**
 * Opens the picture module as #module_open does, which takes some tenths of a second the first time
 * and nothing after.
 * @param[out] error  What is missing and what to install (#STATUS_FAILED).
 * @return The module, or NULL.
 */
const ImagesModule *images_load(Error *error);

/**
 * Opens the picture module of one folder.
 * @param folder      The folder.
 * @param[out] error  What is missing and what to install (#STATUS_FAILED).
 * @return The module, or NULL.
 */
const ImagesModule *images_load_from(const char *folder, Error *error);

/**
 * Writes a picture in a format of the module. Where that holds linear light (OpenEXR, Radiance),
 * the picture is decoded, by the curve of its own encoding.
 * @param module      The module.
 * @param format      The format, as OpenImageIO names it.
 * @param is_linear   Whether it holds linear light.
 * @param picture     The picture.
 * @param stream      Where to; need not be seekable.
 * @param[out] error  Why not (#STATUS_FAILED); the file is not named in it.
 * @return Whether all was handed to the stream; whether it arrives, closing the stream tells.
 */
bool images_write(const ImagesModule *module, const char *format, bool is_linear,
                  const Picture *picture, FILE *stream, Error *error);

/**
 * Reads a picture in a format of the module. Linear light is encoded as sRGB, opacity dropped.
 * @param module        The module.
 * @param format        The format, as OpenImageIO names it.
 * @param path          The file.
 * @param[out] picture  The picture; give it back with #picture_release.
 * @param[out] error    What is wrong (#STATUS_SCENE); the file is not named in it.
 * @return Whether it was read; otherwise the picture is empty.
 */
bool images_read(const ImagesModule *module, const char *format, const char *path, Picture *picture,
                 Error *error);

#endif
