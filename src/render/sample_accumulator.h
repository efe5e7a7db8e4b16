/**
 * @file
 * @brief Sums of samples per pixel, and adaptive sampling: which pixels need more samples.
 *
 * Pixels whose first samples agree get few (Mitchell, *Generating Antialiased Images at Low
 * Sampling Densities*, 1987). A pixel is noisy when two of its samples differ by more than
 * #ADAPTIVE_TOLERANCE steps in any channel. It is active when it or one of its eight neighbours is
 * noisy. All pixels get #adaptive_first_samples samples; then, and whenever their number has
 * doubled, the active pixels are updated, and only these get further samples. A pixel that becomes
 * active late, because a neighbour has become noisy, catches up. The update covers the whole
 * picture between two passes. So it does not depend on threads, tiles or lanes, nor on the number
 * of passes.
 */
#ifndef DIOPTRE_RENDER_SAMPLE_ACCUMULATOR_H
#define DIOPTRE_RENDER_SAMPLE_ACCUMULATOR_H

#include "base/picture.h"
#include "dioptre/engine.h"
#include "render/thread_pool.h"

/** Least number of samples before the first update of active pixels. */
enum { ADAPTIVE_SAMPLES_MINIMUM = 8 };

/** Largest difference of samples of a pixel that is not noisy, in steps of 8 bits. */
enum { ADAPTIVE_TOLERANCE = 2 };

/** The samples of every pixel. */
typedef struct SampleAccumulator {
    int width;        /**< Pixels. */
    int height;       /**< Pixels. */
    double *sums;     /**< Sum of the samples: all reds, all greens, all blues; owned. */
    uint32_t *counts; /**< Number of samples; owned. This and all below: NULL unless adaptive. */
    uint16_t *minima; /**< Code of the least sample, 3 channels per pixel; owned. */
    uint16_t *maxima; /**< Code of the greatest sample, 3 channels per pixel; owned. */
    uint8_t *noisy;   /**< Whether the pixel was noisy at the last update; owned. */
    uint8_t *active;  /**< Whether it or a neighbour was noisy; owned. */
} SampleAccumulator;

/**
 * Resizes an accumulator to a picture.
 * @param[in,out] accumulator  The accumulator, `{0}` or of another size; to be freed with
 *         #sample_accumulator_deinit.
 * @return false without memory; it is empty then.
 */
bool sample_accumulator_resize(SampleAccumulator *accumulator, int width, int height,
                               bool is_adaptive, Error *error);

/** Frees an accumulator and empties it. */
void sample_accumulator_deinit(SampleAccumulator *accumulator);

/** @return Samples that every pixel gets before the first update: a power of two, about a quarter
 * of all, so that with more samples small features are missed less. @param samples Samples per
 * pixel. */
int adaptive_first_samples(int samples);

/** @return Whether active pixels are updated before a sample. @param sample Its number, at least
 *          #adaptive_first_samples. */
bool adaptive_is_update_due(int sample);

/**
 * @return The code of a sample, for comparison.
 * @param beyond_white  Whether codes continue beyond white, with steps about as wide, in proportion
 *         to the light, as those of sRGB at white: for pictures of linear light, whose exposure may
 *         be lowered.
 */
uint16_t adaptive_code(const Encoder *encoder, float linear, bool beyond_white);

/**
 * Updates which pixels are active.
 * @param accumulator  The accumulator, between two passes.
 * @param samples  Samples per pixel.
 * @return Rays that remain, unless further pixels become active.
 */
size_t sample_accumulator_update_active(SampleAccumulator *accumulator, ThreadPool *thread_pool,
                                        int samples);

/**
 * Lists the active pixels of a tile, neighbours together.
 * @param[out] indices  `row * columns + column` of each within the tile.
 * @return Number of active pixels.
 */
size_t sample_accumulator_list_active(const SampleAccumulator *accumulator, const PixelGrid *tile,
                                      uint16_t *indices);

#endif
