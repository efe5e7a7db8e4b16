/**
 * @file
 * @brief Layers: pictures of what rays do, instead of the light that they bring back.
 *
 * Colours are told apart by people who are colour-blind, too: magnitudes go from dark to light
 * (cividis and viridis), shapes have the colours of Okabe and Ito, and every colour stands with its
 * number in a legend.
 */
#ifndef DIOPTRE_LAYER_H
#define DIOPTRE_LAYER_H

#include "dioptre/aov.h"

#include <stdbool.h>
#include <stddef.h>

/** What a picture shows of the rays. */
typedef enum Layer {
    LAYER_SHADED,   /**< The light: the picture itself. */
    LAYER_NORMALS,  /**< The surfaces' unit normals. */
    LAYER_DISTANCE, /**< How far away surfaces are. */
    LAYER_SHAPES,   /**< Which shape is met. */
    LAYER_UV,       /**< Where on a picture: (u, v). */
    LAYER_RAYS,     /**< How many rays a pixel takes. */
    LAYER_STEPS,    /**< How many steps the camera's ray marches. */
    LAYER_TIME,     /**< How long a pixel takes. */
    LAYER_ERROR,    /**< How far its colour is from that of the reference engine. */
    LAYER_ACNE, /**< Where rays meet the surface that they leave, or pass what they should meet. */
    LAYER_COUNT /**< How many there are. */
} Layer;

/** Numbers that are kept of a pixel, at most. */
enum { LAYER_VALUES = 3 };

/** What the pixels of #LAYER_ACNE are. */
typedef enum ShadingArtifact {
    ARTIFACT_NONE, /**< As they should be. */
    ARTIFACT_ACNE, /**< A ray meets the surface that it leaves: dark where there should be light. */
    ARTIFACT_LEAK  /**< A ray does not meet what it should: light where it should be dark. */
} ShadingArtifact;

/** Where the colours of magnitudes begin and end. */
typedef struct LayerScale {
    double low;   /**< The number with the first colour. */
    double high;  /**< The number with the last one. */
    bool is_log;  /**< Whether equal ratios, and not equal differences, are equally far apart. */
    double slope; /**< Share of the colours that a difference of 1 is, of numbers or logarithms. */
} LayerScale;

/** How a layer stands. */
typedef struct LayerStats {
    Layer layer;              /**< Which. */
    LayerScale scale;         /**< Its colours; of those without a scale, zero. */
    uint64_t pixel_count;     /**< Pixels that were looked at. */
    uint64_t artifact_pixels; /**< Of these: in #LAYER_ACNE, those with acne; in #LAYER_ERROR, those
                          that are off by more than a step. */
    uint64_t leak_pixels;     /**< In #LAYER_ACNE, those that leak. */
} LayerStats;

/** One colour of a legend. */
typedef struct LegendEntry {
    uint8_t rgb[3];    /**< The colour. */
    char number[24];   /**< What it stands for, as a number; empty: it is none. */
    const char *label; /**< What it stands for, in words; NULL: in a number. */
} LegendEntry;

/** Colours of a legend, at most. */
enum { LEGEND_ENTRIES_MAXIMUM = 10 };

/** @return A layer's name, such as `distance`. @param layer The layer. */
const char *layer_name(Layer layer);

/** @return What its numbers are, such as `scene units`; empty: there are none. @param layer The
 *  layer. */
const char *layer_unit(Layer layer);

/**
 * Takes the numbers of a layer from a survey. Not for #LAYER_TIME and those that compare.
 * @param layer         The layer.
 * @param sample         What is known of the pixel.
 * @param[out] values  Its numbers; the first is NaN where there is nothing.
 */
void layer_values(Layer layer, const AovSample *sample, float values[LAYER_VALUES]);

/** @return A scale with round ends. @param layer The layer. @param low Least number of a picture.
 *  @param high Greatest one; less than the least where there is none. */
LayerScale layer_scale(Layer layer, double low, double high);

/**
 * Finds the colour of a pixel.
 * @param layer    The layer.
 * @param scale    Its scale.
 * @param values  The pixel's numbers.
 * @param[out] rgb The colour, sRGB.
 */
void layer_color(Layer layer, const LayerScale *scale, const float values[LAYER_VALUES],
                 uint8_t rgb[3]);

/**
 * Writes a layer's legend.
 * @param layer       The layer.
 * @param scale       Its scale.
 * @param[out] entries  The colours, from the highest number to the lowest.
 * @return How many.
 */
size_t layer_legend(Layer layer, const LayerScale *scale,
                    LegendEntry entries[LEGEND_ENTRIES_MAXIMUM]);

#endif
