/**
 * @file
 * @brief Charts of a scene: the time and the errors of each setting.
 */
#ifndef DIOPTRE_LAB_CHARTS_CHART_H
#define DIOPTRE_LAB_CHARTS_CHART_H

#include "dioptre/lab.h"
#include "dioptre/renderer.h"

/** Most settings of a chart. */
enum { CHART_POINTS_MAXIMUM = 64 };
/** Longest name of a setting, bytes with its final zero. */
enum { CHART_LABEL_SIZE = 32 };

/** A setting; all others are the scene's. */
typedef struct ChartPoint {
    const char *setting;          /**< What is set, such as `depth`. */
    char label[CHART_LABEL_SIZE]; /**< Its value. */
    const Engine *engine;         /**< The engine. */
    TraceSettings trace;          /**< Depth, offset and tree. */
    int samples;                  /**< Rays per pixel. */
    double tolerance;             /**< Factor of the tolerances of distance fields. */
    double seconds;               /**< CPU time per megapixel: median of the turns. */
    double seconds_low;           /**< Its lower quartile. */
    double seconds_high;          /**< Its upper quartile. */
    double own_error; /**< RMS error that this setting causes, linear light: rounding of rays on
                         the same path for engines and offsets, truncation for depths and
                         tolerances, noise for samples. */
    double max_steps; /**< Largest such error of a ray, 8-bit steps; of a pixel for samples. */
    double edge_flip_fraction; /**< Fraction of the rays that pass an edge on its other side. */
    double total_error;        /**< RMS error of the picture, linear light. */
    double rounding_fraction;  /**< Fraction of the pixels that change by over a step when numbers
                                  are rounded up or down (#LAYER_ROUNDING), of a picture of half
                                  the width and height with one ray per pixel; NaN: unknown. */
    bool is_pareto;            /**< Whether no setting is both faster and more accurate. */
} ChartPoint;

/** All settings of a scene. */
typedef struct Chart {
    ChartPoint points[CHART_POINTS_MAXIMUM]; /**< All settings, group by group. */
    size_t count;                            /**< Number of #points. */
} Chart;

/**
 * Measures a scene.
 * @param settings    The picture, and how it would be rendered.
 * @param stop        It is given up once this is true; may be NULL.
 * @param[out] chart  The settings.
 * @param[out] error  What is wrong.
 * @return false if anything is wrong.
 */
bool chart_measure(const Scene *scene, const RenderSettings *settings, const atomic_bool *stop,
                   Chart *chart, Error *error);

/**
 * Saves a chart: prints a table, writes `NAME.csv` and `NAME.svg`.
 * @param name            The scene's name.
 * @param[out] has_chart  Whether the SVG is written; it is not if gnuplot is missing.
 * @param[out] error      What is wrong.
 * @return false if anything is wrong.
 */
bool chart_save(const Chart *chart, const char *name, const LabRequest *request, bool *has_chart,
                Error *error);

#endif
