/**
 * @file
 * @brief What the picture module `dioptre-images.so` offers: every format but BMP.
 *
 * OpenImageIO is a C++ library that brings some 260 others with it, so it is not linked with the
 * program but lives in a module of its own, opened when such a format is first asked for. This
 * header is the border between the two, in plain C: numbers, memory and words pass it, and no
 * exception.
 */
#ifndef DIOPTRE_ASSETS_IMAGES_IMAGE_PLUGIN_H
#define DIOPTRE_ASSETS_IMAGES_IMAGE_PLUGIN_H

#include "base/image_metadata.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Counts the changes of this header: program and module must be of the same count. */
enum { IMAGE_PLUGIN_VERSION = 2 };
/** Largest width and height of a picture that is read, as of the whole program. */
enum { IMAGE_PLUGIN_SIZE_MAXIMUM = 16384 };
/** Longest message, in bytes with its final zero. */
enum { IMAGE_PLUGIN_MESSAGE_SIZE = 512 };

/** What went wrong, in words, without the file's name. */
typedef struct ImagePluginMessage {
    char text[IMAGE_PLUGIN_MESSAGE_SIZE]; /**< The words. */
} ImagePluginMessage;

/** A picture to be written. */
typedef struct ImagePluginSource {
    int width;              /**< Pixels. */
    int height;             /**< Pixels. */
    const uint8_t *encoded; /**< Red, green, blue of each pixel, row by row from the top. */
    const float *linear; /**< NULL: the steps are written. Or linear light in the same order: this
                             is written instead. */
    const MetadataEntry
        *metadata; /**< What the file says of itself, ended by a row without a name. */
} ImagePluginSource;

/** A whole file in memory. */
typedef struct EncodedImage {
    const void *bytes; /**< Its bytes. */
    size_t size;       /**< How many. */
    void *owner;       /**< The module's own; NULL when there is nothing to release. */
} EncodedImage;

/** What the numbers of a picture file are. */
typedef enum {
    PIXEL_FORMAT_SRGB8,  /**< Encoded, in 8 bits: read by ImagePlugin::read_steps. */
    PIXEL_FORMAT_SRGB16, /**< Encoded, in more bits: read by ImagePlugin::read_light, 0 to 1. */
    PIXEL_FORMAT_LINEAR  /**< Linear light: read by ImagePlugin::read_light. */
} PixelFormat;

/** What is known of a picture before its pixels are read. */
typedef struct ImageHeader {
    int width;          /**< Pixels, 1 to `IMAGE_PLUGIN_SIZE_MAXIMUM`. */
    int height;         /**< Pixels, 1 to `IMAGE_PLUGIN_SIZE_MAXIMUM`. */
    PixelFormat format; /**< What its numbers are. */
    int strip_rows;     /**< How many rows are read at once, but for the last band. */
} ImageHeader;

/** A picture file that is open; its inside is the module's own. */
typedef struct ImageReader ImageReader;

/** The module: its functions. Formats are named as OpenImageIO does: png, jpeg, tiff, ... */
typedef struct ImagePlugin {
    int version; /**< `IMAGE_PLUGIN_VERSION` as the module was built with. */

    /**
     * Makes a file of a picture. The same picture always gives the same bytes.
     * @param[out] file  The file, to be given back with #free_encoded.
     * @return Whether it was made.
     */
    bool (*encode)(const char *format, const ImagePluginSource *source, EncodedImage *file,
                   ImagePluginMessage *message);

    /** Gives a file's memory back. */
    void (*free_encoded)(EncodedImage *file);

    /**
     * Opens a picture file, reads its header and checks it; reads no pixel.
     * @param format  The format; if the file is of another, it is not read.
     * @param[out] header  What is known of it.
     * @return The open file, to be given back with #close; NULL if anything is wrong.
     */
    ImageReader *(*open)(const char *path, const char *format, ImageHeader *header,
                         ImagePluginMessage *message);

    /**
     * Reads the encoded steps of a band of rows. Opacity is dropped, grey becomes three colours.
     * @param first  First row; a multiple of the band's height.
     * @param count  How many rows; the band's height, or what is left at the bottom.
     * @param[out] rgb  Their pixels, 3 numbers each.
     * @return Whether they were read.
     */
    bool (*read_encoded)(ImageReader *reader, int first, int count, uint8_t *rgb,
                         ImagePluginMessage *message);

    /**
     * Reads a band of rows of the finer kinds; otherwise as #read_encoded.
     * @param[out] rgb  Their pixels, 3 numbers each, of any size, infinity and NaN too.
     * @return Whether they were read.
     */
    bool (*read_linear)(ImageReader *reader, int first, int count, float *rgb,
                        ImagePluginMessage *message);

    /** Closes a picture file. @param reader The open file, or NULL. */
    void (*close)(ImageReader *reader);
} ImagePlugin;

/** Name under which the module offers its one #ImagePlugin. */
#define IMAGE_PLUGIN_SYMBOL "dioptre_image_plugin"

#endif
