/**
 * @file
 * @brief Layers: debug views of the rays, besides the shaded picture.
 *
 * Colours are safe for colour-blind people: magnitudes go from dark to light (cividis), shapes
 * have the colours of Okabe and Ito, and a legend gives the number of every colour.
 */
#ifndef DIOPTRE_LAYER_H
#define DIOPTRE_LAYER_H

#include "dioptre/engine.h"

#include <stdbool.h>
#include <stddef.h>

/** The quantity that a picture shows. New ones are added at the end: links to the page hold these
 *  numbers. */
typedef enum Layer {
    LAYER_SHADED,     /**< Radiance: the picture itself. */
    LAYER_NORMALS,    /**< Unit normals of surfaces. */
    LAYER_DISTANCE,   /**< Distance to surfaces. */
    LAYER_SHAPES,     /**< Which shape is hit. */
    LAYER_UV,         /**< Texture coordinates. */
    LAYER_RAYS,       /**< Rays per pixel. */
    LAYER_STEPS,      /**< Sphere-tracing steps of the camera ray. */
    LAYER_TIME,       /**< Time per pixel. */
    LAYER_ERROR,      /**< Difference from the colour of the reference engine. */
    LAYER_ACNE,       /**< Self-intersections, and hits that are missed. */
    LAYER_ROUNDING,   /**< Difference between pictures whose numbers are rounded to nearest, upwards
                         and downwards. */
    LAYER_OPERATIONS, /**< Operations on distances in the steps of the camera ray. */
    LAYER_COUNT       /**< Number of layers. */
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
    double measured_fraction; /**< Fraction of the picture's pixels that are measured, 0 to 1. */
    const char *reference;    /**< Name of the engine that it is compared with; NULL: none. */
} LayerStats;

/** Largest number of marks. */
enum { LAYER_MARKS_MAXIMUM = 64 };
/** Most pixels with an artefact that are marked: more are seen without. */
enum { LAYER_MARKED_PIXELS = 4 * LAYER_MARKS_MAXIMUM };
/** Artefacts nearer than this to a mark share it, pixels. */
enum { LAYER_MARK_REACH = 12 };

/** Where the artefacts of a picture are, if there are few. */
typedef struct LayerMarks {
    int x[LAYER_MARKS_MAXIMUM]; /**< Columns of pixels with an artefact. */
    int y[LAYER_MARKS_MAXIMUM]; /**< Their rows. */
    size_t count;               /**< Number of marks; 0: no artefact, or too many. */
    bool is_too_many;           /**< Whether there are too many for marks. */
} LayerMarks;

/** A row of a legend: a tick of a bar of colours, or a colour by itself. */
typedef struct LegendEntry {
    uint8_t rgb[3];    /**< The colour. */
    double position;   /**< Position on the bar, 0 to 1; #LEGEND_APART: it is not on the bar. */
    char number[24];   /**< Its number; empty: none. */
    const char *label; /**< Its meaning, in English; NULL: the number. */
} LegendEntry;

/** Position of a colour that is not on the bar. */
#define LEGEND_APART (-1.0)
/** Largest number of rows of a legend. */
enum { LEGEND_ENTRIES_MAXIMUM = 10 };

/** @return A layer's name, such as `distance`, in English. */
const char *layer_name(Layer layer);

/** @return The unit of its numbers, such as `scene units`, in English; empty: none. */
const char *layer_unit(Layer layer);

/**
 * Reads the numbers of a layer from AOVs.
 * @param layer        A layer that is read from AOVs.
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

/**
 * Finds the block of pixels whose time #LAYER_TIME takes together.
 * @param engine  The engine.
 * @param[out] columns  Pixels to the right.
 * @param[out] rows     Pixels down.
 */
void layer_timing_block(const Engine *engine, int *columns, int *rows);

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
 * Finds how far the numbers of two pixels are apart.
 * @param layer  The layer; not #LAYER_SHADED.
 * @return The first minus the second: of normals the angle between them, degrees; of (u, v) the
 *         component that differs most; of shapes 1 where they differ; of artefacts 1 where only the
 *         first has one, -1 where only the second has. NaN: one or both have no number.
 */
double layer_difference(Layer layer, const float a[LAYER_VALUES], const float b[LAYER_VALUES]);

/** @return The unit of #layer_difference, in English; empty: none. */
const char *layer_difference_unit(Layer layer);

/** @return Whether pixels without a number are as true as others: their rays meet nothing. */
bool layer_has_missing(Layer layer);

/** @return A scale for differences from -\p high to \p high: linear below LayerScale.low, then
 *  logarithmic. @param largest Largest difference of the picture, without sign. */
LayerScale layer_difference_scale(Layer layer, double largest);

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
