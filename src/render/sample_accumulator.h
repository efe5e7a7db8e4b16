/**
 * @file
 * @brief The tally: what is known of every pixel of a picture that is drawn sample after sample,
 * and which pixels need more.
 *
 * A pixel that is calm has enough with few samples (Mitchell, *Generating Antialiased Images at Low
 * Sampling Densities*, 1987). It is rough when two of its samples differ by
 * more than #ADAPTIVE_TOLERANCE steps in any primary, of the 8 bits that are written, or of linear
 * light as it will be seen; it is *open* when it or one of its eight neighbours is rough. All
 * pixels get #adaptive_first_samples samples. Then, and whenever their number has doubled, the
 * tally judges which pixels are open; these get all further samples until the next judgement. One
 * that is found open late, because a neighbour has become rough, catches up. The judgement looks at
 * the whole picture between two passes, so it does not depend on threads, blocks or lanes, and is
 * the same whether the samples come one pass each or many.
 */
#ifndef DIOPTRE_RENDER_SAMPLE_ACCUMULATOR_H
#define DIOPTRE_RENDER_SAMPLE_ACCUMULATOR_H

#include "dioptre/engine.h"
#include "dioptre/picture.h"
#include "render/thread_pool.h"

/** Samples that every pixel gets at least, before the first judgement. */
enum { ADAPTIVE_SAMPLES_MINIMUM = 8 };

/** Steps of 255 by which the samples of a calm pixel differ at most. */
enum { ADAPTIVE_TOLERANCE = 2 };

/** What is known of every pixel. */
typedef struct SampleAccumulator {
    int width;        /**< Pixels. */
    int height;       /**< Pixels. */
    double *sums;     /**< Sum of the samples: all reds, all greens, all blues; owned. */
    uint32_t *counts; /**< How many samples; owned. NULL, as all below, where it does not judge. */
    uint16_t *minima; /**< Step of the least sample, 3 numbers a pixel; owned. */
    uint16_t *maxima; /**< Step of the greatest sample, 3 numbers a pixel; owned. */
    uint8_t *noisy;   /**< Whether it was rough at the last judgement; owned. */
    uint8_t *active;  /**< Whether it or a neighbour was; owned. */
} SampleAccumulator;

/**
 * Makes a tally fit a picture.
 * @param[in,out] accumulator  The tally, empty or of another size; give it back with
 *         #sample_accumulator_deinit.
 * @return false without memory; it is empty then.
 */
bool sample_accumulator_resize(SampleAccumulator *accumulator, int width, int height,
                               bool is_adaptive, Error *error);

/** Gives a tally back. */
void sample_accumulator_deinit(SampleAccumulator *accumulator);

/** @return Samples that every pixel gets before the first judgement: a power of two, about a
 * quarter of those that are asked for, so that who asks for more is surer of small things.
 *  @param samples Rays a pixel that are asked for. */
int adaptive_first_samples(int samples);

/** @return Whether pixels are judged before a sample is drawn. @param sample Which, at least
 *          #adaptive_first_samples. */
bool adaptive_is_update_due(int sample);

/**
 * @return The step of a sample, for comparing.
 * @param beyond_white  Whether steps go on beyond white, as shares of the light about as wide as
 *         those of sRGB are there: for pictures that keep their light and may be seen darker than
 *         they are.
 */
uint16_t adaptive_code(const Encoder *encoder, float linear, bool beyond_white);

/**
 * Judges all pixels.
 * @param accumulator  The tally, with nobody at work on it.
 * @param samples  Rays a pixel that are wanted.
 * @return Rays that are still to be drawn, if none is found open later.
 */
size_t sample_accumulator_update_active(SampleAccumulator *accumulator, ThreadPool *thread_pool,
                                        int samples);

/**
 * Lists the open pixels of a block, so that neighbours stand together.
 * @param[out] indices  `row * columns + column` of each within the block.
 * @return How many.
 */
size_t sample_accumulator_list_active(const SampleAccumulator *accumulator, const PixelGrid *tile,
                                      uint16_t *indices);

#endif
