/**
 * @file
 * @brief The difference of two pictures: red where the first is brighter, blue where the second is.
 */
#ifndef DIOPTRE_RENDER_DIFFERENCE_MAP_H
#define DIOPTRE_RENDER_DIFFERENCE_MAP_H

#include "dioptre/layer.h"

/** The difference of two pictures. */
typedef struct DifferenceMap {
    size_t pixel_count;      /**< Pixels of each. */
    size_t differing_pixels; /**< Pixels that differ by more than a step. */
    int max_difference;      /**< Largest difference of a channel, steps. */
} DifferenceMap;

/**
 * Draws a difference; white is none.
 * @param a  A picture: blue, green, red and an unused byte per pixel.
 * @param[out] bgrx  The difference, likewise; may be one of the two.
 * @return The difference.
 */
DifferenceMap difference_map_draw(const uint8_t *a, const uint8_t *b, size_t pixel_count,
                                  uint8_t *bgrx);

/** Writes the legend, from the greatest difference down. @return Number of rows. */
size_t difference_map_legend(LegendEntry entries[LEGEND_ENTRIES_MAXIMUM]);

#endif
