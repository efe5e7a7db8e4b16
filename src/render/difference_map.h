/**
 * @file
 * @brief The difference of two pictures: red where the first is more, blue where the second is.
 *
 * Two pictures of light differ in steps of 8 bits. Two pictures of the same layer differ in the
 * layer's numbers, in its unit. Pictures of two layers have no difference.
 */
#ifndef DIOPTRE_RENDER_DIFFERENCE_MAP_H
#define DIOPTRE_RENDER_DIFFERENCE_MAP_H

#include "dioptre/layer.h"

/** The difference of two pictures. */
typedef struct DifferenceMap {
    Layer layer;             /**< Their layer. */
    bool is_of_two_layers;   /**< Whether they show two layers: there is no difference. */
    LayerScale scale;        /**< The scale, without sign. See #layer_difference_scale. */
    size_t pixel_count;      /**< Pixels of each. */
    size_t differing_pixels; /**< Pixels that differ: in light by more than a step. */
    size_t unknown_pixels;   /**< Pixels of which one, or both, have no number. */
    double max_difference;   /**< Largest difference, without sign. */
} DifferenceMap;

/**
 * Draws the difference of two pictures of light; white is none.
 * @param a  A picture: blue, green, red and an unused byte per pixel.
 * @param[out] bgrx  The difference, likewise; may be one of the two.
 * @return The difference.
 */
DifferenceMap difference_map_draw(const uint8_t *a, const uint8_t *b, size_t pixel_count,
                                  uint8_t *bgrx);

/**
 * Draws the difference of two pictures of the same layer; white is none, grey is unknown.
 * @param layer  Their layer; not #LAYER_SHADED.
 * @param a      #LAYER_VALUES numbers of each pixel.
 * @param[out] bgrx  See #difference_map_draw.
 * @return The difference.
 */
DifferenceMap difference_map_draw_values(Layer layer, const float *a, const float *b,
                                         size_t pixel_count, uint8_t *bgrx);

/** Draws grey: two layers have no difference. @param[out] bgrx See #difference_map_draw. */
DifferenceMap difference_map_draw_none(size_t pixel_count, uint8_t *bgrx);

/** Finds the colour of a difference. @param value The difference; NaN: unknown. */
void difference_map_color(const DifferenceMap *map, double value, uint8_t rgb[3]);

/** Finds the colour at a position of the bar. @param fraction 0, the lowest, to 1. */
void difference_map_bar_color(double fraction, uint8_t rgb[3]);

/** Writes the legend, from the greatest difference down. @return Number of rows. */
size_t difference_map_legend(const DifferenceMap *map, LegendEntry entries[LEGEND_ENTRIES_MAXIMUM]);

#endif
