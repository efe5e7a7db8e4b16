/**
 * @file
 * @brief Charts: lines on logarithmic axes, drawn by gnuplot from a table of comma-separated
 * values.
 *
 * Each line has its name at its end, in its colour, and a sign of its own, so that black and white
 * will do; no colour is one that the colour-blind take for another (Okabe and Ito, 2008).
 */
#ifndef DIOPTRE_LAB_CHARTS_PLOT_H
#define DIOPTRE_LAB_CHARTS_PLOT_H

#include "dioptre/error.h"

#include <stdatomic.h>
#include <stddef.h>

/** Most lines of a panel. */
enum { PLOT_SERIES_MAXIMUM = 16 };
/** Most panels of a chart. */
enum { PLOT_PANELS_MAXIMUM = 12 };

/** A line: the rows of the table whose first two cells are given. */
typedef struct PlotSeries {
    const char *label;       /**< What stands at its end. */
    const char *row_keys[2]; /**< First and second cell of its rows. */
    int y_column;            /**< Column of its y, from 1. */
    const double *x;         /**< Its points, as they stand in the table. */
    const double *y; /**< NaN: there is none at this x. 0: drawn on the floor, which says 0. */
    size_t count;    /**< How many. */
    int style;       /**< Colour and sign, from 0; the same in all panels for the same thing. */
} PlotSeries;

/** A panel: some lines over one x. */
typedef struct PlotPanel {
    const char *title;                      /**< Over it. */
    const char *x_label;                    /**< What x is, with its unit. */
    const char *y_label;                    /**< What y is, with its unit. */
    int x_column;                           /**< Column of x, from 1. */
    PlotSeries series[PLOT_SERIES_MAXIMUM]; /**< The lines. */
    size_t series_count;                    /**< How many. */
    double y_low;                           /**< Least y that is shown, above 0. */
    double y_high;                          /**< Largest. */
    bool has_zero_floor;                    /**< Whether y_low stands for 0. */
    bool is_x_reversed;                     /**< Whether x grows to the left. */
} PlotPanel;

/** A chart. */
typedef struct Plot {
    const char *title;                     /**< Over it. */
    const char *csv;                       /**< The table's file. */
    PlotPanel panels[PLOT_PANELS_MAXIMUM]; /**< Row by row. */
    size_t panel_count;                    /**< How many panels. */
    size_t columns;                        /**< Panels side by side. */
} Plot;

/** Finds what must be shown of y in panels that are to be compared: whole powers of ten. */
void plot_set_common_y_range(PlotPanel *panels, size_t count);

/**
 * Draws a chart.
 * @param stop  It is given up once this is true; may be NULL.
 * @return Whether it is in its place.
 */
bool plot_draw(const Plot *plot, const char *path, const atomic_bool *stop, Error *error);

#endif
