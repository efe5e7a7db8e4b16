/**
 * @file
 * @brief The tally: what is known of every pixel of a picture that is drawn sample after sample,
 * and which pixels need more.
 *
 * A pixel that is calm has enough with few samples (Mitchell, *Generating Antialiased Images at Low
 * Sampling Densities*, 1987). It is rough when two of its samples differ by
 * more than #TALLY_CALM steps in any primary, of the 8 bits that are written, or of linear light as
 * it will be seen; it is *open* when it or one of its eight
 * neighbours is rough. All pixels get #tally_first samples. Then, and whenever their number has
 * doubled, the tally judges which pixels are open; these get all further samples until the next
 * judgement. One that is found open late, because a neighbour has become rough, catches up. The
 * judgement looks at the whole picture between two passes, so it does not depend on threads, blocks
 * or lanes, and is the same whether the samples come one pass each or many.
 */
#ifndef DIOPTRE_RENDER_TALLY_H
#define DIOPTRE_RENDER_TALLY_H

#include "dioptre/engine.h"
#include "dioptre/picture.h"
#include "render/workers.h"

/** Samples that every pixel gets at least, before the first judgement. */
enum { TALLY_LEAST = 8 };

/** Steps of 255 by which the samples of a calm pixel differ at most. */
enum { TALLY_CALM = 2 };

/** What is known of every pixel. */
typedef struct Tally {
    int width;        /**< Pixels. */
    int height;       /**< Pixels. */
    double *sums;     /**< Sum of the samples: all reds, all greens, all blues; owned. */
    uint32_t *counts; /**< How many samples; owned. NULL, as all below, where it does not judge. */
    uint16_t *lows;   /**< Step of the least sample, 3 numbers a pixel; owned. */
    uint16_t *highs;  /**< Step of the greatest sample, 3 numbers a pixel; owned. */
    uint8_t *rough;   /**< Whether it was rough at the last judgement; owned. */
    uint8_t *open;    /**< Whether it or a neighbour was; owned. */
} Tally;

/**
 * Makes a tally fit a picture.
 * @param[in,out] tally  The tally, empty or of another size; give it back with #tally_release.
 * @param width       Pixels.
 * @param height      Pixels.
 * @param judges      Whether it judges.
 * @param[out] error  What is wrong.
 * @return false without memory; it is empty then.
 */
bool tally_resize(Tally *tally, int width, int height, bool judges, Error *error);

/** Gives a tally back. @param tally The tally. */
void tally_release(Tally *tally);

/** @return Samples that every pixel gets before the first judgement: a power of two, about a
 * quarter of those that are asked for, so that who asks for more is surer of small things.
 *  @param samples Rays a pixel that are asked for. */
int tally_first(int samples);

/** @return Whether pixels are judged before a sample is drawn. @param sample Which, at least
 *          #tally_first. */
bool tally_is_due(int sample);

/**
 * @return The step of a sample, for comparing.
 * @param encoder       Which steps.
 * @param light         The sample.
 * @param beyond_white  Whether steps go on beyond white, as shares of the light about as wide as
 *                      those of sRGB are there: for pictures that keep their light and may be seen
 *                      darker than they are.
 */
uint16_t tally_step(const Encoder *encoder, float light, bool beyond_white);

/**
 * Judges all pixels.
 * @param tally    The tally, with nobody at work on it.
 * @param workers  Who does it.
 * @param samples  Rays a pixel that are wanted.
 * @return Rays that are still to be drawn, if none is found open later.
 */
size_t tally_judge(Tally *tally, Workers *workers, int samples);

/**
 * Lists the open pixels of a block, so that neighbours stand together.
 * @param tally        The tally.
 * @param block        The block.
 * @param[out] places  `row * columns + column` of each within the block.
 * @return How many.
 */
size_t tally_open(const Tally *tally, const PixelGrid *block, uint16_t *places);

#endif
