/**
 * @file
 * @brief Reads pictures in a child process, out of harm's way.
 *
 * The libraries behind the picture module were written for files from friends: a damaged or
 * malicious one can make them read and write beyond their memory (the JPEG reader of OpenImageIO
 * 2.4 does so for `bad-iptc.jpg` of its own test files) or never come to an end. What happens in a
 * child stays there.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_SANDBOX_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_SANDBOX_H

#include "assets/images/image_plugin_io.h"

/** What reading a picture may take. */
typedef struct ImageReadLimits {
    double time_limit;       /**< Time, by the clock on the wall. */
    size_t memory_limit;     /**< Bytes of the libraries' own. */
    size_t texture_capacity; /**< Bytes of the texels, decoded. */
} ImageReadLimits;

/**
 * Reads a picture as #image_plugin_read does, but in a child process.
 * @param format  The format, as OpenImageIO names it.
 * @param[out] texture  The picture, tame, to be given back with #texture_release; NULL if anything
 *         is wrong.
 * @param[out] error  What is wrong (#STATUS_SCENE; #STATUS_FAILED without memory or process).
 * @return Whether it was read.
 */
bool image_sandbox_read(const ImagePlugin *plugin, const char *format, const char *path,
                        const ImageReadLimits *limits, Texture **texture, Error *error);

#endif
