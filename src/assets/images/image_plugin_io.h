/**
 * @file
 * @brief Opens the picture module and moves pictures across its border.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_PLUGIN_IO_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_PLUGIN_IO_H

#include "assets/images/image_plugin.h"
#include "base/picture.h"
#include "dioptre/scene.h"

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

/** @return Linear light of a picture, decoded from its 8-bit steps by the curve of its encoding; to
 *  be freed. NULL without memory. */
float *image_plugin_decode(const Picture *picture);

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
