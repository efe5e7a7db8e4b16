/**
 * @file
 * @brief From sums of samples to 8 bits: rows of a picture.
 */
#ifndef DIOPTRE_RENDER_ROW_ENCODER_H
#define DIOPTRE_RENDER_ROW_ENCODER_H

#include "base/picture.h"

/** A row of rays whose samples were summed. */
typedef struct SampleRow {
    const double *sums;     /**< Sums of the samples: the reds of the row. */
    size_t plane;           /**< Distance from the reds to the greens, and to the blues. */
    const uint32_t *counts; /**< Number of samples of each ray, at least 1. */
    int columns;            /**< Number of rays. */
} SampleRow;

/**
 * Averages and encodes a row, eight rays at once where the processor has AVX2.
 * @param encoder   The tables.
 * @param row       The row.
 * @param[out] rgb  Red, green, blue of each ray.
 */
void row_encode(const Encoder *encoder, const SampleRow *row, uint8_t *rgb);

/** #row_encode without AVX2; the bytes are the same. @param first The first ray that is encoded. */
void row_encode_from(const Encoder *encoder, const SampleRow *row, int first, uint8_t *rgb);

#endif
