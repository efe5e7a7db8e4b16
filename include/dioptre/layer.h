/**
 * @file
 * @brief Layers: debug views of the rays, besides the shaded picture.
 *
 * Colours are safe for colour-blind people: magnitudes go from dark to light (cividis and viridis),
 * shapes have the colours of Okabe and Ito, and a legend gives the number of every colour.
 */
#ifndef DIOPTRE_LAYER_H
#define DIOPTRE_LAYER_H

#include "dioptre/engine.h"

#include <stdbool.h>
#include <stddef.h>

/** The quantity that a picture shows. */
typedef enum Layer {
    LAYER_SHADED,   /**< Radiance: the picture itself. */
    LAYER_NORMALS,  /**< Unit normals of surfaces. */
    LAYER_DISTANCE, /**< Distance to surfaces. */
    LAYER_SHAPES,   /**< Which shape is hit. */
    LAYER_UV,       /**< Texture coordinates. */
    LAYER_RAYS,     /**< Rays per pixel. */
    LAYER_STEPS,    /**< Sphere-tracing steps of the camera ray. */
    LAYER_TIME,     /**< Time per pixel. */
    LAYER_ERROR,    /**< Difference from the colour of the reference engine. */
    LAYER_ACNE,     /**< Self-intersections, and hits that are missed. */
    LAYER_ROUNDING, /**< Difference between pictures whose numbers are rounded to nearest, upwards
                       and downwards. */
    LAYER_COUNT     /**< Number of layers. */
} Layer;

/** Largest number of values per pixel. */
enum { LAYER_VALUES = 3 };

/** The pixels of #LAYER_ACNE. */
typedef enum ShadingArtifact {
    ARTIFACT_NONE, /**< As in the reference. */
    ARTIFACT_ACNE, /**< A ray hits the surface that it leaves: dark, should be lit. */
    ARTIFACT_LEAK  /**< A ray misses what it should hit: lit, should be dark. */
} ShadingArtifact;

/** The scale of a layer of magnitudes. */
typedef struct LayerScale {
    double low;   /**< Number of the first colour. */
    double high;  /**< Number of the last colour. */
    bool is_log;  /**< Whether it is logarithmic. */
    double slope; /**< Fraction of the palette per unit of the number or its logarithm. */
} LayerScale;

/** The statistics of a layer. */
typedef struct LayerStats {
    Layer layer;              /**< The layer. */
    LayerScale scale;         /**< Its scale; zero for layers without one. */
    uint64_t pixel_count;     /**< Rays, one per pixel at full resolution. */
    uint64_t artifact_pixels; /**< Of these, in #LAYER_ACNE: with acne; in #LAYER_ERROR and
                                 #LAYER_ROUNDING: with a number of more than a step. */
    uint64_t leak_pixels;     /**< In #LAYER_ACNE: with a leak. */
} LayerStats;

/** A row of a legend. */
typedef struct LegendEntry {
    uint8_t rgb[3];    /**< The colour. */
    char number[24];   /**< Its number; empty: none. */
    const char *label; /**< Its meaning, in English; NULL: the number. */
} LegendEntry;

/** Largest number of rows of a legend. */
enum { LEGEND_ENTRIES_MAXIMUM = 10 };

/** @return A layer's name, such as `distance`, in English. */
const char *layer_name(Layer layer);

/** @return The unit of its numbers, such as `scene units`, in English; empty: none. */
const char *layer_unit(Layer layer);

/**
 * Reads the numbers of a layer from AOVs.
 * @param layer        A layer before #LAYER_TIME.
 * @param sample       The AOVs of the pixel.
 * @param[out] values  Its numbers; the first is NaN without a hit.
 */
void layer_values(Layer layer, const AovSample *sample, float values[LAYER_VALUES]);

/**
 * @return A scale with round ends.
 * @param layer  The layer.
 * @param low    Smallest number of the picture.
 * @param high   Largest number; below \p low if there is none.
 */
LayerScale layer_scale(Layer layer, double low, double high);

/**
 * Finds the colour of a pixel.
 * @param layer    The layer.
 * @param scale    Its scale.
 * @param values   Its numbers.
 * @param[out] rgb The colour, sRGB.
 */
void layer_color(Layer layer, const LayerScale *scale, const float values[LAYER_VALUES],
                 uint8_t rgb[3]);

/** Bytes of #layer_value_text with the final zero. */
enum { LAYER_TEXT_SIZE = 96 };

/**
 * Writes the numbers of a pixel in words, in the user's language.
 * @param layer   The layer; not #LAYER_SHADED.
 * @param values  Its numbers.
 * @param[out] text  Such as `3.42 scene units`.
 */
void layer_value_text(Layer layer, const float values[LAYER_VALUES], char text[LAYER_TEXT_SIZE]);

/**
 * Writes a layer's legend.
 * @param layer       The layer.
 * @param scale       Its scale.
 * @param[out] entries  The rows, from the highest number to the lowest.
 * @return Number of rows.
 */
size_t layer_legend(Layer layer, const LayerScale *scale,
                    LegendEntry entries[LEGEND_ENTRIES_MAXIMUM]);

#endif
