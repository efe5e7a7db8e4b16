/**
 * @file
 * @brief Charts of a scene: what each setting costs, and what it leaves of errors.
 */
#ifndef DIOPTRE_CHART_H
#define DIOPTRE_CHART_H

#include "dioptre/lab.h"
#include "dioptre/renderer.h"

/** Most settings of a chart. */
enum { CHART_POINTS_MAXIMUM = 64 };
/** Longest name of a setting, bytes with its final zero. */
enum { CHART_LABEL_SIZE = 32 };

/** A setting: all others are as the scene has them. */
typedef struct ChartPoint {
    const char *setting;          /**< What is set, such as `depth`. */
    char label[CHART_LABEL_SIZE]; /**< To what. */
    const Engine *engine;         /**< The engine. */
    TraceSettings trace;          /**< Depth, offset and tree. */
    int samples;                  /**< Rays a pixel. */
    double tolerance;    /**< How many times as coarse as the scene's those of fields are. */
    double seconds;      /**< The processor's time for a megapixel: median of the turns. */
    double seconds_low;  /**< Its lower quartile. */
    double seconds_high; /**< Its upper quartile. */
    double own_error;    /**< The error that this setting is for, root of the mean square of linear
                        light:    rounding of engines and offsets, of rays that took the same way; what
                        else    is missing, of depths and tolerances; noise of samples. */
    double max_steps;    /**< The largest such error, 8-bit steps; of samples: of whole pixels. */
    double edge_flip_fraction; /**< Share of the rays that passed an edge on its other side. */
    double total_error;        /**< All errors of the picture together, root of the mean square. */
    bool is_pareto;            /**< Whether nothing is both faster and nearer to the truth. */
} ChartPoint;

/** What is known of a scene. */
typedef struct Chart {
    ChartPoint points[CHART_POINTS_MAXIMUM]; /**< The settings, group by group. */
    size_t count;                            /**< How many. */
} Chart;

/**
 * Measures a scene.
 * @param scene       The scene.
 * @param settings    The picture, and how it would be drawn.
 * @param stop        It is given up once this is true; may be NULL.
 * @param[out] chart  What is known.
 * @param[out] error  What is wrong.
 * @return false if anything is.
 */
bool chart_measure(const Scene *scene, const RenderSettings *settings, const atomic_bool *stop,
                   Chart *chart, Error *error);

/**
 * Keeps what is known of a scene: prints a table, writes `NAME.csv` and `NAME.svg`.
 * @param chart           What is known.
 * @param name            The scene's name.
 * @param request         Where to.
 * @param[out] has_chart  Whether there is an SVG; there is none where gnuplot is missing.
 * @param[out] error      What is wrong.
 * @return false if anything is.
 */
bool chart_save(const Chart *chart, const char *name, const LabRequest *request, bool *has_chart,
                Error *error);

#endif
