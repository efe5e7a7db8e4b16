/**
 * @file
 * @brief Where the names of lines and points stand in a panel, so that they do not overlap.
 */
#ifndef DIOPTRE_LAB_CHARTS_PLOT_LABELS_H
#define DIOPTRE_LAB_CHARTS_PLOT_LABELS_H

#include "lab/charts/plot.h"

/** Axes of a panel, logarithmic. */
typedef struct PlotAxes {
    double x_left;       /**< At the left end. */
    double x_right;      /**< At the right end. */
    double x_first;      /**< The first x of the data. */
    double x_last;       /**< The last x of the data; names of lines stand beyond. */
    double y_low;        /**< At the lower end. */
    double y_high;       /**< At the upper end. */
    bool has_zero_floor; /**< Whether y_low is labelled 0. */
} PlotAxes;

/** Pixels of a panel of points. */
enum { POINTS_WIDTH = 660, POINTS_HEIGHT = 600 };
/** Pixels around the axes of a panel of points. */
enum { POINTS_LEFT = 90, POINTS_RIGHT = 15, POINTS_TOP = 90, POINTS_BOTTOM = 80 };
/** Pixels inside the axes of a panel of points. */
enum {
    POINTS_INNER_WIDTH = POINTS_WIDTH - POINTS_LEFT - POINTS_RIGHT,
    POINTS_INNER_HEIGHT = POINTS_HEIGHT - POINTS_TOP - POINTS_BOTTOM
};

/** The name of a line. */
typedef struct LineLabel {
    const PlotSeries *series; /**< The line. */
    double height;            /**< Position, 0 at the lower to 1 at the upper end of the axis. */
} LineLabel;

/** Places the names of lines at their ends. @return How many. */
size_t plot_line_labels(const PlotPanel *panel, const PlotAxes *axes,
                        LineLabel labels[PLOT_SERIES_MAXIMUM]);

/** A rectangle in pixels from the lower left end of the axes, y upwards. */
typedef struct LabelBox {
    double left;   /**< Left side. */
    double right;  /**< Right side. */
    double bottom; /**< Lower side. */
    double top;    /**< Upper side. */
} LabelBox;

/** Places the names of points: as near to them as there is room, to the right if possible. */
void plot_point_labels(const PlotPanel *panel, const PlotAxes *axes,
                       LabelBox labels[PLOT_POINTS_MAXIMUM]);

/** @return The position of a point: a rectangle without size. */
LabelBox plot_point_position(const PlotPoint *point, const PlotAxes *axes);

/** @return Whether a name is so far from its point that a line must join them. */
bool plot_label_is_displaced(const LabelBox *point, const LabelBox *label);

#endif
