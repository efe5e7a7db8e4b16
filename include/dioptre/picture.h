/**
 * @file
 * @brief Pictures: linear sums of samples, and the 8-bit picture that comes of them.
 */
#ifndef DIOPTRE_PICTURE_H
#define DIOPTRE_PICTURE_H

#include "dioptre/image_metadata.h"
#include "dioptre/scene.h"

#include <stdint.h>

/** A finished picture, as in a file or on a screen. */
typedef struct Picture {
    int width;         /**< Pixels. */
    int height;        /**< Pixels. */
    uint8_t *pixels;   /**< Red, green, blue of each pixel, row by row from the top; owned. */
    Encoding encoding; /**< Which light the pixels stand for; formats of linear light need it. */
    float *linear;     /**< The same as linear light, before it was rounded to steps; owned. NULL:
                           not kept. */
    const MetadataEntry *metadata; /**< What files of it say, ended by a row without a name; NULL:
                                   nothing. Not owned. */
} Picture;

/**
 * Makes a black picture; its encoding is #ENCODING_SRGB.
 * @param[out] picture  The picture; give it back with #picture_deinit.
 * @param width         Pixels, at least 1.
 * @param height        Pixels, at least 1.
 * @param[out] error    What is wrong.
 * @return false without memory; the picture is then empty.
 */
bool picture_init(Picture *picture, int width, int height, Error *error);

/**
 * Makes a picture keep its linear light, too; black at first.
 * @param[in,out] picture  The picture.
 * @param[out] error       What is wrong.
 * @return false without memory.
 */
bool picture_allocate_linear(Picture *picture, Error *error);

/** Gives a picture's pixels back and empties it. @param picture The picture. */
void picture_deinit(Picture *picture);

/** The exact curve from linear light to 8 bits, as tables. Made by #encoder_init. */
typedef struct Encoder {
    float thresholds[257];     /**< Smallest light that is shown as 0, 1, ... 255; then infinity. */
    uint8_t first_codes[4097]; /**< Number shown at the lower end of each 4096th of the light. */
} Encoder;

/**
 * Makes the tables of an encoding.
 * @param[out] encoder  The tables.
 * @param encoding      Which curve.
 */
void encoder_init(Encoder *encoder, Encoding encoding);

/**
 * Encodes linear light: rounded to the nearest of 256 steps of the encoded scale, exactly.
 * @param encoder  The tables.
 * @param linear    Any number; below 0 and NaN give 0, above 1 gives 255.
 * @return 0 to 255.
 */
static inline uint8_t encoder_encode(const Encoder *encoder, float linear) {
    float clamped = linear > 0 ? (linear < 1 ? linear : 1) : 0;
    unsigned code = encoder->first_codes[(unsigned)(clamped * 4096)];
    return (uint8_t)(code + (clamped >= encoder->thresholds[code + 1]));
}

/** How two pictures of the same size differ. */
typedef struct PictureComparison {
    int width;                 /**< Pixels. */
    int height;                /**< Pixels. */
    int max_difference;        /**< Largest difference of a channel, in 8-bit steps. */
    double differing_fraction; /**< Share of pixels with a channel off by more than one step. */
    double rmse; /**< Root of the mean square difference, of linear light (sRGB decoded). */
    double psnr; /**< Peak signal to noise, decibels, of the 8-bit steps; infinite if equal. */
} PictureComparison;

/**
 * Compares two pictures.
 * @param a             A picture.
 * @param b             Another, of the same size.
 * @param[out] map      NULL, or an empty picture of that size for the steps that each pixel is off:
 *                      black where equal, then bright with the largest difference of a channel.
 * @return How they differ.
 */
PictureComparison picture_compare(const Picture *a, const Picture *b, Picture *map);

#endif
