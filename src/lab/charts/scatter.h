/**
 * @file
 * @brief Charts of points with names on logarithmic axes, drawn by gnuplot from a table of
 *        comma-separated values: time to the right, error upwards.
 *
 * What nothing beats in both is joined by a line, the front, and has its name in bold.
 */
#ifndef DIOPTRE_LAB_CHARTS_SCATTER_H
#define DIOPTRE_LAB_CHARTS_SCATTER_H

#include "dioptre/error.h"

#include <stdatomic.h>
#include <stddef.h>

/** Most points of a panel. */
enum { SCATTER_POINTS_MAXIMUM = 64 };
/** Most panels of a chart. */
enum { SCATTER_PANELS_MAXIMUM = 2 };
/** Most kinds of points. */
enum { SCATTER_KINDS_MAXIMUM = 4 };

/** A point. */
typedef struct ScatterPoint {
    const char *label; /**< Its name. */
    double x;          /**< Above 0. */
    double y;          /**< At least 0: that is drawn on the floor. */
    int kind;          /**< Its colour and sign, from 0. */
    bool is_pareto;    /**< Whether nothing is both more to the left and lower. */
} ScatterPoint;

/** A panel. */
typedef struct ScatterPanel {
    const char *title;                           /**< Over it. */
    const char *y_label;                         /**< What y is, with its unit. */
    int y_column;                                /**< Column of y, from 1. */
    bool is_fraction;                            /**< Whether y is at most 1. */
    ScatterPoint points[SCATTER_POINTS_MAXIMUM]; /**< As they stand in the table. */
    size_t point_count;                          /**< How many. */
} ScatterPanel;

/** A chart. */
typedef struct Scatter {
    const char *title;                           /**< Over it. */
    const char *csv;                             /**< The table's file. */
    const char *x_label;                         /**< What x is, with its unit. */
    int x_columns[3];                            /**< Columns of x and of its ends, from 1. */
    int kind_column;                             /**< Column of a point's kind. */
    const char *kinds[SCATTER_KINDS_MAXIMUM];    /**< The kinds, as the table calls them. */
    size_t kind_count;                           /**< How many. */
    ScatterPanel panels[SCATTER_PANELS_MAXIMUM]; /**< Side by side. */
    size_t panel_count;                          /**< How many. */
} Scatter;

/** Finds out of a panel's points which nothing beats. */
void scatter_find_pareto_front(ScatterPanel *panel);

/**
 * Draws a chart.
 * @param stop  It is given up once this is true; may be NULL.
 * @return Whether it is in its place.
 */
bool scatter_draw(const Scatter *scatter, const char *path, const atomic_bool *stop, Error *error);

#endif
