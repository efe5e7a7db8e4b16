/**
 * @file
 * @brief The difference of two pictures: red where the first is brighter, blue where the second is.
 */
#ifndef DIOPTRE_RENDER_DIFFERENCE_MAP_H
#define DIOPTRE_RENDER_DIFFERENCE_MAP_H

#include "dioptre/layer.h"

/** How two pictures differ. */
typedef struct DifferenceMap {
    size_t pixel_count;      /**< Pixels of each. */
    size_t differing_pixels; /**< Pixels that are off by more than a step of 255. */
    int max_difference;      /**< Steps of the one that is off most. */
} DifferenceMap;

/**
 * Draws a difference. White is none; the colours of few steps are far apart.
 * @param a  A picture: blue, green, red and an unused byte a pixel.
 * @param[out] bgrx  Their difference, likewise; may be one of the two.
 * @return How they differ.
 */
DifferenceMap difference_map_draw(const uint8_t *a, const uint8_t *b, size_t pixel_count,
                                  uint8_t *bgrx);

/** Writes the legend: steps, from the greatest down. @return How many. */
size_t difference_map_legend(LegendEntry entries[LEGEND_ENTRIES_MAXIMUM]);

#endif
