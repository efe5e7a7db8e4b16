/**
 * @file
 * @brief Places the names of lines and points.
 */
#include "lab/charts/plot_labels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- names at the ends of lines ------------------------------------------------------------------
 */

/** Least distance between two names, relative to a panel's height. */
#define LINE_LABEL_HEIGHT 0.055

/** @return Order of two names from the bottom, for qsort. */
static int compare_line_labels(const void *a, const void *b) {
    double x = ((const LineLabel *)a)->height, y = ((const LineLabel *)b)->height;
    return (x > y) - (x < y);
}

/** @return The position of y on its axis, 0 to 1. */
static double relative_height(const PlotAxes *axes, double y) {
    double low = log10(axes->y_low), high = log10(axes->y_high);
    double at = (log10(fmin(fmax(y, axes->y_low), axes->y_high)) - low) / (high - low);
    return fmin(fmax(at, 0), 1);
}

/** Moves names apart that would overlap: upwards from the bottom, then back from the top. */
static void spread_line_labels(LineLabel *labels, size_t count) {
    qsort(labels, count, sizeof *labels, compare_line_labels);
    if (count > 0) {
        labels[0].height = fmax(labels[0].height, LINE_LABEL_HEIGHT / 2); // Above the axis.
    }
    for (size_t i = 1; i < count; i++) {
        labels[i].height = fmax(labels[i].height, labels[i - 1].height + LINE_LABEL_HEIGHT);
    }
    double top = 1;
    for (size_t i = count; i-- > 0; top = labels[i].height - LINE_LABEL_HEIGHT) {
        labels[i].height = fmin(labels[i].height, top);
    }
}

size_t plot_line_labels(const PlotPanel *panel, const PlotAxes *axes,
                        LineLabel labels[PLOT_SERIES_MAXIMUM]) {
    size_t count = 0;
    for (size_t i = 0; i < panel->series_count; i++) {
        const PlotSeries *line = &panel->series[i];
        size_t last = line->count;
        while (last > 0 && isnan(line->y[last - 1])) {
            last--;
        }
        if (last > 0) {
            labels[count++] = (LineLabel){line, relative_height(axes, line->y[last - 1])};
        }
    }
    spread_line_labels(labels, count);
    return count;
}

/* --- names beside points -------------------------------------------------------------------------
 */

/** Pixels of a name: its height, and the width of a letter. */
enum { LABEL_HEIGHT = 14, CHARACTER_WIDTH = 7 };
/** Pixels of a name to the right of its point, and above it and its error bar. */
enum { LABEL_GAP = 6, LABEL_RISE = 9 };
/** Pixels from the centre of a point's sign to its sides. */
enum { POINT_RADIUS = 5 };
/** Pixels between two positions that are tried for a name, along x and along y. */
enum { LABEL_STEP_X = 28, LABEL_STEP_Y = LABEL_HEIGHT / 2 };
/** How many positions are tried on each side, to the left and right, above and below. */
enum { LABEL_STEPS_X = 20, LABEL_STEPS_Y = 60 };

LabelBox plot_point_position(const PlotPoint *point, const PlotAxes *axes) {
    double right = log(point->x / axes->x_left) / log(axes->x_right / axes->x_left);
    double up = log(fmax(point->y, axes->y_low) / axes->y_low) / log(axes->y_high / axes->y_low);
    double x = right * POINTS_INNER_WIDTH, y = up * POINTS_INNER_HEIGHT;
    return (LabelBox){x, x, y, y};
}

/** @return Whether a rectangle overlaps any of some. */
static bool overlaps_any(const LabelBox *box, const LabelBox *others, size_t count) {
    bool is_any = false;
    for (size_t i = 0; i < count; i++) {
        const LabelBox *other = &others[i];
        is_any = is_any || (box->left < other->right && other->left < box->right &&
                            box->bottom < other->top && other->bottom < box->top);
    }
    return is_any;
}

/** @return A position of a name. @param wide Its width, pixels. @param x Steps to the right, or
 * from -1 on to the left. @param y Steps up. */
static LabelBox label_box_at(const LabelBox *at, double wide, int x, int y) {
    double left = x >= 0 ? at->left + LABEL_GAP + x * LABEL_STEP_X
                         : at->left - LABEL_GAP - wide + (x + 1) * LABEL_STEP_X;
    double middle = at->top + LABEL_RISE + y * LABEL_STEP_Y;
    return (LabelBox){left, left + wide, middle - LABEL_HEIGHT / 2.0, middle + LABEL_HEIGHT / 2.0};
}

/** @return Whether a name is inside the panel. */
static bool label_is_inside(const LabelBox *label) {
    return label->left > 0 && label->right < POINTS_INNER_WIDTH + POINTS_RIGHT &&
           label->bottom > 0 && label->top < POINTS_INNER_HEIGHT + LABEL_HEIGHT;
}

void plot_point_labels(const PlotPanel *panel, const PlotAxes *axes,
                       LabelBox labels[PLOT_POINTS_MAXIMUM]) {
    LabelBox points[PLOT_POINTS_MAXIMUM];
    for (size_t i = 0; i < panel->point_count; i++) {
        LabelBox at = plot_point_position(&panel->points[i], axes);
        points[i] = (LabelBox){at.left - POINT_RADIUS, at.left + POINT_RADIUS,
                               at.top - POINT_RADIUS, at.top + POINT_RADIUS};
    }
    for (size_t i = 0; i < panel->point_count; i++) {
        LabelBox at = plot_point_position(&panel->points[i], axes);
        double wide = CHARACTER_WIDTH * ((double)strlen(panel->points[i].label) + 0.5);
        double best = INFINITY;
        labels[i] = label_box_at(&at, wide, 0, 0);
        for (int n = 0; n < 2 * LABEL_STEPS_X * 2 * LABEL_STEPS_Y; n++) {
            int x = n % (2 * LABEL_STEPS_X) - LABEL_STEPS_X;
            int y = n / (2 * LABEL_STEPS_X) - LABEL_STEPS_Y;
            LabelBox label = label_box_at(&at, wide, x, y);
            // The right side first, then what is nearest.
            double away = hypot((x < 0 ? -x : x) * LABEL_STEP_X, y * LABEL_STEP_Y);
            if (away < best && label_is_inside(&label) && !overlaps_any(&label, labels, i) &&
                !overlaps_any(&label, points, panel->point_count)) {
                labels[i] = label;
                best = away;
            }
        }
    }
}

bool plot_label_is_displaced(const LabelBox *point, const LabelBox *label) {
    double middle = (label->bottom + label->top) / 2;
    return fabs(middle - point->top - LABEL_RISE) > LABEL_HEIGHT / 2.0 ||
           label->left > point->left + 2 * LABEL_GAP || label->right < point->left - 2 * LABEL_GAP;
}
