/**
 * @file
 * @brief Opens the picture module and moves pictures across its border.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_PLUGIN_IO_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_PLUGIN_IO_H

#include "assets/images/image_plugin.h"
#include "dioptre/picture.h"

#include <stdio.h>

/**
 * Opens the picture module as #plugin_open does, which takes some tenths of a second the first time
 * and nothing after.
 * @param[out] error  What is missing and what to install (#STATUS_FAILED).
 * @return The module, or NULL.
 */
const ImagePlugin *image_plugin_load(Error *error);

/**
 * Opens the picture module of one folder.
 * @param[out] error  What is missing and what to install (#STATUS_FAILED).
 * @return The module, or NULL.
 */
const ImagePlugin *image_plugin_load_from(const char *folder, Error *error);

/**
 * Writes a picture in a format of the module. Where that holds linear light (OpenEXR, Radiance),
 * the picture's own light is written, if it was kept; else it is decoded from the steps, by the
 * curve of the picture's encoding.
 * @param format  The format, as OpenImageIO names it.
 * @param is_linear  Whether it holds linear light.
 * @param stream  Where to; need not be seekable.
 * @param[out] error  Why not (#STATUS_FAILED); the file is not named in it.
 * @return Whether all was handed to the stream; whether it arrives, closing the stream tells.
 */
bool image_plugin_write(const ImagePlugin *plugin, const char *format, bool is_linear,
                        const Picture *picture, FILE *stream, Error *error);

/** A picture file to be read. */
typedef struct ImageReadRequest {
    const ImagePlugin *plugin; /**< The module. */
    const char *format;        /**< The format, as OpenImageIO names it. */
    const char *path;          /**< The file. */
    size_t texture_capacity;   /**< Bytes that fit where the texture goes. */
} ImageReadRequest;

/**
 * Reads a picture. Opacity is dropped. 8-bit numbers stay as they are, encoded as sRGB; finer ones
 * become linear light by the same curve; floats are linear light.
 * @param[out] texture  Where to: ImageReadRequest.texture_capacity bytes.
 * @param[out] error  What is wrong (#STATUS_SCENE); the file is not named in it.
 * @return Whether it was read.
 */
bool image_plugin_read(const ImageReadRequest *request, Texture *texture, Error *error);

#endif
