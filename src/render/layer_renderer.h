/**
 * @file
 * @brief The table of layers, and how a layer is measured.
 *
 * A new layer is a #Layer, a row of the table in layer.c and its functions: #LayerClass.color, and
 * #LayerClass.read where it comes from AOVs, or #LayerClass.measure where it does not.
 */
#ifndef DIOPTRE_RENDER_LAYER_RENDERER_H
#define DIOPTRE_RENDER_LAYER_RENDERER_H

#include "render/renderer_internal.h"

/** The engine that a layer is compared with. */
typedef enum {
    REFERENCE_NONE,   /**< None. */
    REFERENCE_DOUBLE, /**< Double: paths are all that counts. */
    REFERENCE_EXACT   /**< The widest, or double where that is wider than the engine. */
} LayerReference;

/** A row of a legend that is always the same. */
typedef struct FixedLegendEntry {
    float values[LAYER_VALUES]; /**< Numbers of a pixel of its colour. */
    const char *number;         /**< The number; empty: see #label. */
    const char *label;          /**< The label, in English; NULL: see #number. */
} FixedLegendEntry;

/** A layer: one row of the table. */
typedef struct LayerClass {
    const char *name;               /**< See #layer_name. */
    const char *unit;               /**< See #layer_unit. */
    const FixedLegendEntry *legend; /**< Its legend, ended by an empty row; NULL: it has a scale. */
    double scale_low;         /**< Low end of a scale that is always the same; 0: by values. */
    double scale_high;        /**< High end of it. */
    const char *zero_label;   /**< Label of the number 0 in the legend, in English; NULL: none. */
    bool has_missing;         /**< Whether some pixels have no number: NaN. */
    unsigned aov_mask;        /**< The AOVs that it needs. See #AOV_RADIANCE. */
    LayerReference reference; /**< The engine that it is compared with. */
    bool has_preview;         /**< Whether a pass of the picture alone comes first. */
    bool is_timed;            /**< Whether rays are measured in small groups, one by one. */
    int repeats;              /**< Passes at full resolution; 0: one. */

    /** Reads its numbers from the AOVs of a pixel; NULL: they do not come from AOVs. */
    void (*read)(const AovSample *sample, float values[LAYER_VALUES]);

    /**
     * Measures a strip of rays into #LayerRenderer.values; NULL: by #read.
     * @param strip  A few rows of rays of a tile, or a group of rays.
     * @param[in,out] counts  The rays traced are added to this.
     */
    void (*measure)(const RenderPass *pass, const PixelGrid *strip, RayCounts *counts);

    /**
     * Finds the artefact of a measured ray, once all are measured; NULL: there are none.
     * @param cell  Index of the ray in the pass.
     * @param[in,out] values  Its numbers.
     */
    ShadingArtifact (*classify)(const RenderPass *pass, size_t cell, float values[LAYER_VALUES]);

    /** Finds how far the numbers of two pixels are apart; NULL: the first minus the second. See
     *  #layer_difference. */
    double (*difference)(const float *a, const float *b);
    const char *difference_unit; /**< Its unit, in English; NULL: #unit. */
    double difference_high;      /**< Its largest value; 0: by values. */

    /** Finds the colour of a pixel that has numbers. */
    void (*color)(const LayerScale *scale, const float *values, uint8_t rgb[3]);
} LayerClass;

/** @return The row of a layer. */
const LayerClass *layer_class(Layer layer);

/** Measures the error against the reference engine. See #LayerClass.measure. */
void measure_error(const RenderPass *pass, const PixelGrid *strip, RayCounts *counts);

/** Measures how far a pixel changes when numbers are rounded upwards and downwards, not to nearest.
 *  See #LayerClass.measure. */
void measure_rounding(const RenderPass *pass, const PixelGrid *strip, RayCounts *counts);

/** Compares paths with those of the reference engine. See #LayerClass.measure. */
void measure_artifacts(const RenderPass *pass, const PixelGrid *strip, RayCounts *counts);

/** Measures the time per ray; of several passes the shortest counts. See #LayerClass.measure. */
void measure_time(const RenderPass *pass, const PixelGrid *strip, RayCounts *counts);

/** Counts numbers of more than a step as #ARTIFACT_ACNE. See #LayerClass.classify. */
ShadingArtifact classify_error(const RenderPass *pass, size_t cell, float values[LAYER_VALUES]);

/** Drops artefacts at edges, where either path is right. See #LayerClass.classify. */
ShadingArtifact classify_path(const RenderPass *pass, size_t cell, float values[LAYER_VALUES]);

/** Measures the rays of a tile. See #ShadeTile. */
void layer_measure_tile(RenderPass *pass, const PixelGrid *tile, size_t index);

/** @return Rays of a pass per row of the picture. */
static inline size_t layer_pass_columns(const RenderPass *pass) {
    return ((size_t)pass->width + (size_t)pass->range.stride - 1) / (size_t)pass->range.stride;
}

/** @return Index of a ray among those of the pass. @param column Its column in the grid. */
static inline size_t layer_cell_index(const RenderPass *pass, const PixelGrid *grid, int column,
                                      int row) {
    size_t x = (size_t)(grid->x / pass->range.stride + column);
    size_t y = (size_t)(grid->y / pass->range.stride + row);
    return y * layer_pass_columns(pass) + x;
}

/** @return The numbers of a ray. See #layer_cell_index. */
static inline float *layer_cell_values(const RenderPass *pass, const PixelGrid *grid, int column,
                                       int row) {
    return pass->renderer->layer_renderer.values +
           LAYER_VALUES * layer_cell_index(pass, grid, column, row);
}

#endif
