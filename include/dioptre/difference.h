/**
 * @file
 * @brief The difference of two pictures: red where the first is brighter, blue where the second is.
 */
#ifndef DIOPTRE_DIFFERENCE_H
#define DIOPTRE_DIFFERENCE_H

#include "dioptre/layer.h"

/** How two pictures differ. */
typedef struct Difference {
    size_t pixels; /**< Pixels of each. */
    size_t off;    /**< Pixels that are off by more than a step of 255. */
    int worst;     /**< Steps of the one that is off most. */
} Difference;

/**
 * Draws a difference. White is none; the colours of few steps are far apart.
 * @param a          A picture: blue, green, red and an unused byte a pixel.
 * @param b          Another.
 * @param pixels     Pixels of each.
 * @param[out] bgrx  Their difference, likewise; may be one of the two.
 * @return How they differ.
 */
Difference difference_draw(const uint8_t *a, const uint8_t *b, size_t pixels, uint8_t *bgrx);

/** Writes the legend: steps, from the greatest down. @param[out] ticks The colours. @return How
 *  many. */
size_t difference_legend(LayerTick ticks[LAYER_TICKS]);

#endif
