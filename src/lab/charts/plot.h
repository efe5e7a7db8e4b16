/**
 * @file
 * @brief Charts on logarithmic axes, drawn by gnuplot from a table of comma-separated values.
 *
 * A chart is a grid of panels. A panel shows series of the table's rows: as lines with names at
 * their ends, or as points with error bars along x, each with a name. All colours are distinct for
 * the colour-blind (Okabe and Ito, 2008), and each has its own marker for black and white.
 */
#ifndef DIOPTRE_LAB_CHARTS_PLOT_H
#define DIOPTRE_LAB_CHARTS_PLOT_H

#include "base/error.h"

#include <stdatomic.h>
#include <stddef.h>

/** Most series of a panel. */
enum { PLOT_SERIES_MAXIMUM = 16 };
/** Most named points of a panel. */
enum { PLOT_POINTS_MAXIMUM = 64 };
/** Most panels of a chart. */
enum { PLOT_PANELS_MAXIMUM = 12 };

/** How the rows of a series are drawn. */
typedef enum PlotKind {
    PLOT_LINES, /**< Joined by a line, with the series' name at its end. */
    PLOT_POINTS /**< Points with error bars, each with its own name. */
} PlotKind;

/** A cell that rows must have to be part of a series. */
typedef struct PlotKey {
    int column;        /**< From 1. */
    const char *value; /**< NULL: any. */
} PlotKey;

/** Rows of the table in one colour and sign. */
typedef struct PlotSeries {
    const char *label; /**< Its name. */
    PlotKey keys[2];   /**< Which rows. */
    int y_column;      /**< Column of y, from 1. */
    int style;         /**< Colour and sign, from 0; the same in all panels for the same thing. */
    const double *x;   /**< Of a line: x as in the table, above 0. */
    const double *y;   /**< Of a line: y. NaN: none. 0: drawn on the floor, labelled 0. */
    size_t count;      /**< Number of points of a line. */
} PlotSeries;

/** A point with a name. */
typedef struct PlotPoint {
    const char *label; /**< Its name. */
    double x;          /**< As in the table, above 0. */
    double y;          /**< At least 0; 0 is drawn on the floor. */
    int style;         /**< Of its series. */
    bool is_pareto;    /**< Whether it is part of the Pareto front, which a line joins. */
} PlotPoint;

/** A panel. */
typedef struct PlotPanel {
    const char *title;                      /**< Above it. */
    const char *x_label;                    /**< What x is, with its unit. */
    const char *y_label;                    /**< What y is, with its unit. */
    int x_columns[3];                       /**< Columns of x and of its error bar's ends. */
    PlotSeries series[PLOT_SERIES_MAXIMUM]; /**< The series. */
    size_t series_count;                    /**< Number of #series. */
    PlotPoint points[PLOT_POINTS_MAXIMUM];  /**< Of #PLOT_POINTS: the points of all series. */
    size_t point_count;                     /**< Number of #points. */
    bool is_fraction;                       /**< Of #PLOT_POINTS: whether y is at most 1. */
    bool is_x_reversed;                     /**< Of #PLOT_LINES: whether x grows to the left. */
    double y_low;                           /**< Of #PLOT_LINES: least y of the axis, above 0. */
    double y_high;                          /**< Of #PLOT_LINES: largest y of the axis. */
    bool has_zero_floor;                    /**< Of #PLOT_LINES: whether y_low is labelled 0. */
} PlotPanel;

/** A chart. */
typedef struct Plot {
    PlotKind kind;                         /**< How all panels are drawn. */
    const char *title;                     /**< Above it. */
    const char *csv;                       /**< The table's file. */
    PlotPanel panels[PLOT_PANELS_MAXIMUM]; /**< Row by row. */
    size_t panel_count;                    /**< Number of #panels. */
    size_t columns;                        /**< Panels side by side. */
} Plot;

/** Gives panels of lines the same y axis, in whole powers of ten. */
void plot_set_common_y_range(PlotPanel *panels, size_t count);

/**
 * Draws a chart.
 * @param path        The SVG file to write.
 * @param stop        It is given up once this is true; may be NULL.
 * @param[out] error  What is wrong.
 * @return Whether the file is written.
 */
bool plot_draw(const Plot *plot, const char *path, const atomic_bool *stop, Error *error);

#endif
