/**
 * @file
 * @brief Calls of the picture module.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_PLUGIN_IO_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_PLUGIN_IO_H

#include "assets/images/image_plugin.h"
#include "base/picture.h"
#include "dioptre/scene.h"

#include <stdio.h>

/**
 * Loads the picture module, see #plugin_open. The first call takes some tenths of a second.
 * @param[out] error  What is missing, and the package to install (#STATUS_FAILED).
 * @return The module, or NULL.
 */
const ImagePlugin *image_plugin_load(Error *error);

/**
 * Loads the picture module from a folder.
 * @param folder      The folder.
 * @param[out] error  What is missing, and the package to install (#STATUS_FAILED).
 * @return The module, or NULL.
 */
const ImagePlugin *image_plugin_load_from(const char *folder, Error *error);

/**
 * @return Linear light of a picture, decoded from its 8-bit codes; to be freed with `free`. NULL
 *         without memory.
 * @param picture  The picture.
 */
float *image_plugin_decode(const Picture *picture);

/** A picture file to read. */
typedef struct ImageReadRequest {
    const ImagePlugin *plugin; /**< The module. */
    const char *format;        /**< Name of the format in OpenImageIO. */
    int file;                  /**< Descriptor of the file. */
    size_t texture_capacity;   /**< Bytes available for the texture. */
    bool is_capacity_shared;   /**< Whether other files of the scene have taken the rest. */
} ImageReadRequest;

/**
 * Reads a picture. Opacity is ignored. 8-bit numbers stay encoded as sRGB; encoded numbers of more
 * bits are decoded to linear light; floats are linear light.
 * @param request       The request.
 * @param[out] texture  Memory of #ImageReadRequest.texture_capacity bytes.
 * @param[out] error    What is wrong (#STATUS_SCENE), without the path.
 * @return Whether it was read.
 */
bool image_plugin_read(const ImageReadRequest *request, Texture *texture, Error *error);

#endif
