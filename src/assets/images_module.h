/**
 * @file
 * @brief What the picture module `dioptre-images.so` offers: every format but BMP.
 *
 * OpenImageIO is a C++ library that brings some 260 others with it, so it is not linked with the
 * program but lives in a module of its own, opened when such a format is first asked for. This
 * header is the border between the two, in plain C: numbers, memory and words pass it, and no
 * exception.
 */
#ifndef ASSETS_IMAGES_MODULE_H
#define ASSETS_IMAGES_MODULE_H

#include "dioptre/picture_note.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/** Counts the changes of this header: program and module must be of the same count. */
enum { IMAGES_MODULE_VERSION = 2 };
/** Largest width and height of a picture that is read, as of the whole program. */
enum { IMAGES_SIZE_MAXIMUM = 16384 };
/** Longest message, in bytes with its final zero. */
enum { IMAGES_MESSAGE_SIZE = 512 };

/** What went wrong, in words, without the file's name. */
typedef struct ImagesMessage {
    char text[IMAGES_MESSAGE_SIZE]; /**< The words. */
} ImagesMessage;

/** A picture to be written. */
typedef struct ImagesSource {
    int width;            /**< Pixels. */
    int height;           /**< Pixels. */
    const uint8_t *steps; /**< Red, green, blue of each pixel, row by row from the top. */
    const float *light;   /**< NULL: the steps are written. Or linear light in the same order: this
                               is written instead. */
    const PictureNote *notes; /**< What the file says of itself, ended by a row without a name. */
} ImagesSource;

/** A whole file in memory. */
typedef struct ImagesFile {
    const void *bytes; /**< Its bytes. */
    size_t size;       /**< How many. */
    void *owner;       /**< The module's own; NULL when there is nothing to release. */
} ImagesFile;

/** What the numbers of a picture file are. */
typedef enum {
    IMAGES_STEPS, /**< Encoded, in 8 bits: read by ImagesModule::read_steps. */
    IMAGES_FINE,  /**< Encoded, in more bits: read by ImagesModule::read_light, 0 to 1. */
    IMAGES_LIGHT  /**< Linear light: read by ImagesModule::read_light. */
} ImagesKind;

/** What is known of a picture before its pixels are read. */
typedef struct ImagesHeader {
    int width;       /**< Pixels, 1 to `IMAGES_SIZE_MAXIMUM`. */
    int height;      /**< Pixels, 1 to `IMAGES_SIZE_MAXIMUM`. */
    ImagesKind kind; /**< What its numbers are. */
    int band;        /**< How many rows are read at once, but for the last band. */
} ImagesHeader;

/** A picture file that is open; its inside is the module's own. */
typedef struct ImagesReader ImagesReader;

/** The module: its functions. Formats are named as OpenImageIO does: png, jpeg, tiff, ... */
typedef struct ImagesModule {
    int version; /**< `IMAGES_MODULE_VERSION` as the module was built with. */

    /**
     * Makes a file of a picture. The same picture always gives the same bytes.
     * @param format        The format.
     * @param source        The picture.
     * @param[out] file     The file, to be given back with #release.
     * @param[out] message  What is wrong.
     * @return Whether it was made.
     */
    bool (*encode)(const char *format, const ImagesSource *source, ImagesFile *file,
                   ImagesMessage *message);

    /** Gives a file's memory back. @param file The file. */
    void (*release)(ImagesFile *file);

    /**
     * Opens a picture file, reads its header and checks it; reads no pixel.
     * @param path          The file.
     * @param format        The format; if the file is of another, it is not read.
     * @param[out] header   What is known of it.
     * @param[out] message  What is wrong.
     * @return The open file, to be given back with #close; NULL if anything is wrong.
     */
    ImagesReader *(*open)(const char *path, const char *format, ImagesHeader *header,
                          ImagesMessage *message);

    /**
     * Reads the encoded steps of a band of rows. Opacity is dropped, grey becomes three colours.
     * @param reader        The open file.
     * @param first         First row; a multiple of the band's height.
     * @param count         How many rows; the band's height, or what is left at the bottom.
     * @param[out] rgb      Their pixels, 3 numbers each.
     * @param[out] message  What is wrong.
     * @return Whether they were read.
     */
    bool (*read_steps)(ImagesReader *reader, int first, int count, uint8_t *rgb,
                       ImagesMessage *message);

    /**
     * Reads a band of rows of the finer kinds; otherwise as #read_steps.
     * @param reader        The open file.
     * @param first         First row.
     * @param count         How many rows.
     * @param[out] rgb      Their pixels, 3 numbers each, of any size, infinity and NaN too.
     * @param[out] message  What is wrong.
     * @return Whether they were read.
     */
    bool (*read_light)(ImagesReader *reader, int first, int count, float *rgb,
                       ImagesMessage *message);

    /** Closes a picture file. @param reader The open file, or NULL. */
    void (*close)(ImagesReader *reader);
} ImagesModule;

/** Name under which the module offers its one #ImagesModule. */
#define IMAGES_MODULE_SYMBOL "dioptre_images_module"

#endif
