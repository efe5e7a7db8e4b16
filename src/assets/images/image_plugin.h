/**
 * @file
 * @brief Interface of the picture module `dioptre-images.so`: every format but BMP.
 *
 * OpenImageIO is a C++ library with some 260 dependencies. It is therefore not linked with the
 * program, but with a module that is loaded at first use. This header is its interface in plain C;
 * no exception crosses it.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_PLUGIN_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_PLUGIN_H

#include "base/image_metadata.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Version of this interface; program and module must agree. */
enum { IMAGE_PLUGIN_VERSION = 3 };
/** Largest width and height of a picture, as in the program. */
enum { IMAGE_PLUGIN_SIZE_MAXIMUM = 16384 };
/** Size of a message, with its final zero. */
enum { IMAGE_PLUGIN_MESSAGE_SIZE = 512 };

/** An error message, without the file's name. */
typedef struct ImagePluginMessage {
    char text[IMAGE_PLUGIN_MESSAGE_SIZE]; /**< The text. */
} ImagePluginMessage;

/** A picture to write. */
typedef struct ImagePluginSource {
    int width;              /**< Width in pixels. */
    int height;             /**< Height in pixels. */
    const uint8_t *encoded; /**< Red, green, blue of each pixel, row by row from the top. */
    const float *linear;    /**< Linear light in the same order, which is written instead; NULL:
                               #encoded is written. */
    const MetadataEntry *metadata; /**< Metadata, ended by a row without a name. */
} ImagePluginSource;

/** A picture file in memory. */
typedef struct EncodedImage {
    const void *bytes; /**< Its bytes. */
    size_t size;       /**< Number of bytes. */
    void *owner;       /**< Internal to the module; NULL: nothing to release. */
} EncodedImage;

/** Type of the numbers of a picture file. */
typedef enum {
    PIXEL_FORMAT_SRGB8,  /**< Encoded, 8 bits: read by #ImagePlugin.read_encoded. */
    PIXEL_FORMAT_SRGB16, /**< Encoded, more bits: read by #ImagePlugin.read_linear as 0 to 1. */
    PIXEL_FORMAT_LINEAR  /**< Linear light: read by #ImagePlugin.read_linear. */
} PixelFormat;

/** Properties of a picture, known before its pixels are read. */
typedef struct ImageHeader {
    int width;          /**< Width in pixels, 1 to `IMAGE_PLUGIN_SIZE_MAXIMUM`. */
    int height;         /**< Height in pixels, 1 to `IMAGE_PLUGIN_SIZE_MAXIMUM`. */
    PixelFormat format; /**< Type of its numbers. */
    int strip_rows;     /**< Number of rows per strip; the last strip may have fewer. */
} ImageHeader;

/** An open picture file; opaque. */
typedef struct ImageReader ImageReader;

/** The functions of the module. Formats have their names in OpenImageIO: png, jpeg, tiff, ... */
typedef struct ImagePlugin {
    int version; /**< #IMAGE_PLUGIN_VERSION at the build of the module. */

    /**
     * Encodes a picture as a file. The same picture always gives the same bytes.
     * @param format        The format.
     * @param source        The picture.
     * @param[out] file     The file, to be freed with #free_encoded.
     * @param[out] message  What is wrong.
     * @return Whether it was encoded.
     */
    bool (*encode)(const char *format, const ImagePluginSource *source, EncodedImage *file,
                   ImagePluginMessage *message);

    /** Frees a file in memory. */
    void (*free_encoded)(EncodedImage *file);

    /**
     * Opens a picture file, and reads and checks its header.
     * @param file          Descriptor of the file, which stays open: the worker that calls this may
     *                      not open files by name.
     * @param format        The format; a file of another one is refused.
     * @param[out] header   Its properties.
     * @param[out] message  What is wrong.
     * @return The open file, to be closed with #close; NULL on errors.
     */
    ImageReader *(*open)(int file, const char *format, ImageHeader *header,
                         ImagePluginMessage *message);

    /**
     * Reads a strip of rows, encoded. Opacity is ignored; grey becomes three equal channels.
     * @param reader        The open file.
     * @param first         First row; a multiple of #ImageHeader.strip_rows.
     * @param count         Number of rows: #ImageHeader.strip_rows, or fewer at the bottom.
     * @param[out] rgb      The pixels, 3 numbers each.
     * @param[out] message  What is wrong.
     * @return Whether they were read.
     */
    bool (*read_encoded)(ImageReader *reader, int first, int count, uint8_t *rgb,
                         ImagePluginMessage *message);

    /**
     * Reads a strip of rows with more than 8 bits; see #read_encoded.
     * @param reader        The open file.
     * @param first         First row.
     * @param count         Number of rows.
     * @param[out] rgb      The pixels, 3 numbers each; of any value, even infinity and NaN.
     * @param[out] message  What is wrong.
     * @return Whether they were read.
     */
    bool (*read_linear)(ImageReader *reader, int first, int count, float *rgb,
                        ImagePluginMessage *message);

    /**
     * @return Whether the library complained about the strips that it has read: the file ends
     *         early or is damaged, and some pixels are guesses.
     * @param reader  The open file.
     */
    bool (*is_damaged)(ImageReader *reader);

    /** Closes a picture file. @param reader The open file, or NULL. */
    void (*close)(ImageReader *reader);
} ImagePlugin;

/** Symbol of the #ImagePlugin in the module. */
#define IMAGE_PLUGIN_SYMBOL "dioptre_image_plugin"

#endif
