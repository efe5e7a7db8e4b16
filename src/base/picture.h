/**
 * @file
 * @brief Pictures of 8 bits per channel, their encoding, and their comparison.
 */
#ifndef DIOPTRE_BASE_PICTURE_H
#define DIOPTRE_BASE_PICTURE_H

#include "base/encoding.h"
#include "base/error.h"
#include "base/image_metadata.h"

#include <stdint.h>

/** A picture, as in a file or on a screen. */
typedef struct Picture {
    int width;         /**< Pixels. */
    int height;        /**< Pixels. */
    uint8_t *pixels;   /**< Red, green, blue of each pixel, row by row from the top; owned. */
    Encoding encoding; /**< Transfer curve of #pixels; formats of linear light need it. */
    float *linear;     /**< The same in linear light, not rounded to 8 bits; owned, may be NULL. */
    const MetadataEntry *metadata; /**< Metadata for files, ended by an empty row; not owned, may be
                                        NULL. */
} Picture;

/**
 * Initialises a black picture in sRGB.
 * @param[out] picture  The picture, to be freed with #picture_deinit; empty on failure.
 * @param width         Pixels, at least 1.
 * @param height        Pixels, at least 1.
 * @param[out] error    No memory.
 * @return false without memory.
 */
bool picture_init(Picture *picture, int width, int height, Error *error);

/**
 * Allocates the linear light of a picture: black.
 * @param[in,out] picture  The picture.
 * @param[out] error       No memory.
 * @return false without memory.
 */
bool picture_allocate_linear(Picture *picture, Error *error);

/** Frees a picture's pixels and empties it. */
void picture_deinit(Picture *picture);

/**
 * Number of cells of the table over 0 to 1. Each cell contains at most one threshold: the smallest
 * distance of two, at the dark end of sRGB, is 1 / (12.92 * 255).
 */
enum { ENCODER_CELLS = 4096 };

/** Tables that encode linear light exactly. See #encoder_init. */
typedef struct Encoder {
    float thresholds[257]; /**< Smallest light encoded as 0, 1, ... 255; then infinity. */
    uint8_t first_codes[ENCODER_CELLS + 1 + 3]; /**< Code at the lower end of each cell; then three
                                                     bytes, as vectors load four at once. */
} Encoder;

/**
 * Computes the tables of an encoding.
 * @param[out] encoder  The tables.
 * @param encoding      The transfer curve.
 */
void encoder_init(Encoder *encoder, Encoding encoding);

/**
 * Encodes linear light: exactly rounded to the nearest of 256 codes.
 * @param encoder  The tables.
 * @param linear    Any number; below 0 and NaN give 0, above 1 gives 255.
 * @return 0 to 255.
 */
static inline uint8_t encoder_encode(const Encoder *encoder, float linear) {
    float clamped = linear > 0 ? (linear < 1 ? linear : 1) : 0;
    unsigned code = encoder->first_codes[(unsigned)(clamped * ENCODER_CELLS)];
    return (uint8_t)(code + (clamped >= encoder->thresholds[code + 1]));
}

/** The difference of two pictures of the same size. */
typedef struct PictureComparison {
    int width;                 /**< Pixels. */
    int height;                /**< Pixels. */
    int max_difference;        /**< Largest difference of a channel, in codes. */
    double differing_fraction; /**< Fraction of the pixels that differ by more than one code. */
    double rmse;               /**< Root mean square difference of linear light (sRGB decoded). */
    double psnr; /**< Peak signal-to-noise ratio of the codes, decibels; infinite if equal. */
} PictureComparison;

/**
 * Compares two pictures.
 * @param a             A picture.
 * @param b             Another, of the same size.
 * @param[out] map      NULL, or a picture of that size for the largest difference of a channel of
 *                      each pixel: black where equal, brighter the more they differ.
 * @return Their difference.
 */
PictureComparison picture_compare(const Picture *a, const Picture *b, Picture *map);

#endif
