/**
 * @file
 * @brief Charts of points with names.
 */
#include "lab/charts/scatter.h"

#include "lab/charts/gnuplot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Pixels of a panel, and of what is around its axes. */
enum { WIDTH = 660, HEIGHT = 600, LEFT = 90, RIGHT = 15, TOP = 75, BOTTOM = 80 };
/** Pixels of a name: its height, and what a letter is wide. */
enum { LABEL_HEIGHT = 14, CHARACTER_WIDTH = 7 };
/** Pixels of a name to the right of its point, and above it and its spread. */
enum { LABEL_GAP = 6, LABEL_RISE = 9 };
/** Share of x that is left for the name of the last point. */
#define LABEL_WIDTH_FRACTION 0.22

/** The ends of a panel's axes. */
typedef struct AxisRange {
    double x_low;        /**< At the left. */
    double x_high;       /**< At the right. */
    double y_low;        /**< Below. */
    double y_high;       /**< Above. */
    bool has_zero_floor; /**< Whether y_low stands for 0. */
} AxisRange;

/** A rectangle of pixels, upwards from the lower left corner of the axes. */
typedef struct LabelBox {
    double left;   /**< Its left side. */
    double right;  /**< Its right side. */
    double bottom; /**< Below. */
    double top;    /**< Above. */
} LabelBox;

/** @return Whether one point is better than another: left of it and not higher, or lower and not to
 *  its right. */
static bool dominates(const ScatterPoint *a, const ScatterPoint *b) {
    return (a->x < b->x && a->y <= b->y) || (a->x <= b->x && a->y < b->y);
}

void scatter_find_pareto_front(ScatterPanel *panel) {
    for (size_t i = 0; i < panel->point_count; i++) {
        panel->points[i].is_pareto = true;
        for (size_t k = 0; k < panel->point_count; k++) {
            if (dominates(&panel->points[k], &panel->points[i])) {
                panel->points[i].is_pareto = false;
            }
        }
    }
}

/** @return The ends of a panel's axes. @param panel The panel, with a point at least. */
static AxisRange axis_range_of(const ScatterPanel *panel) {
    AxisRange ends = {INFINITY, 0, INFINITY, 0, false};
    for (size_t i = 0; i < panel->point_count; i++) {
        const ScatterPoint *point = &panel->points[i];
        ends.x_low = fmin(ends.x_low, point->x);
        ends.x_high = fmax(ends.x_high, point->x);
        ends.has_zero_floor = ends.has_zero_floor || point->y == 0;
        ends.y_low = point->y > 0 ? fmin(ends.y_low, point->y) : ends.y_low;
        ends.y_high = fmax(ends.y_high, point->y);
    }
    if (ends.y_high == 0) {
        ends.y_low = ends.y_high = 1; // All of it is zero.
    }
    double wide = fmax(log10(ends.x_high / ends.x_low), 0.3);
    ends.x_high = ends.x_low * pow(10, wide / (1 - LABEL_WIDTH_FRACTION));
    ends.x_low /= pow(10, 0.05 * wide);
    ends.y_low = pow(10, floor(log10(ends.y_low)) - ends.has_zero_floor);
    // The key stands above all points, but no share is above 1.
    ends.y_high = pow(10, floor(log10(ends.y_high)) + 2);
    ends.y_high = panel->is_fraction ? fmin(ends.y_high, 1) : ends.y_high;
    return ends;
}

/** @return Where a point is, pixels from the lower left corner of the axes: a rectangle without
 *  size. */
static LabelBox point_position(const ScatterPoint *point, const AxisRange *ends) {
    double right = log(point->x / ends->x_low) / log(ends->x_high / ends->x_low);
    double up = log(fmax(point->y, ends->y_low) / ends->y_low) / log(ends->y_high / ends->y_low);
    double x = right * (WIDTH - LEFT - RIGHT), y = up * (HEIGHT - TOP - BOTTOM);
    return (LabelBox){x, x, y, y};
}

/** @return Whether two rectangles have something in common. */
static bool label_box_overlaps(const LabelBox *a, const LabelBox *b) {
    return a->left < b->right && b->left < a->right && a->bottom < b->top && b->bottom < a->top;
}

/**
 * @return Whether a name can stand somewhere: on no other name, on no point.
 * @param names  Those that have their place.
 */
static bool label_box_is_free(const LabelBox *box, const LabelBox *names, size_t count,
                              const LabelBox *points, size_t point_count) {
    bool label_box_is_free = box->bottom > 0 && box->top < HEIGHT - TOP - BOTTOM + LABEL_HEIGHT;
    for (size_t i = 0; i < count; i++) {
        label_box_is_free = label_box_is_free && !label_box_overlaps(box, &names[i]);
    }
    for (size_t i = 0; i < point_count; i++) {
        label_box_is_free = label_box_is_free && !label_box_overlaps(box, &points[i]);
    }
    return label_box_is_free;
}

/** Finds where names stand: beside their points, or as little above or below as there is room. */
static void place_point_labels(const ScatterPanel *panel, const AxisRange *ends,
                               LabelBox names[SCATTER_POINTS_MAXIMUM]) {
    LabelBox points[SCATTER_POINTS_MAXIMUM];
    for (size_t i = 0; i < panel->point_count; i++) {
        LabelBox at = point_position(&panel->points[i], ends);
        points[i] = (LabelBox){at.left - 5, at.left + 5, at.top - 5, at.top + 5};
    }
    for (size_t i = 0; i < panel->point_count; i++) {
        LabelBox at = point_position(&panel->points[i], ends);
        double wide = CHARACTER_WIDTH * (double)strlen(panel->points[i].label);
        for (int try = 0; try < 80; try++) {
            double label_shift = (try % 2 ? 1 : -1) * ((try + 1) / 2) * (LABEL_HEIGHT / 2.0);
            double middle = at.top + LABEL_RISE + label_shift, left = at.left + LABEL_GAP;
            names[i] = (LabelBox){left, left + wide, middle - LABEL_HEIGHT / 2.0,
                                  middle + LABEL_HEIGHT / 2.0};
            if (label_box_is_free(&names[i], names, i, points, panel->point_count)) {
                break;
            }
        }
    }
}

/** Writes a line from a point to its name that stands elsewhere. */
static void write_leader_line(const LabelBox *at, const LabelBox *name, FILE *script) {
    double middle = (name->bottom + name->top) / 2;
    if (fabs(middle - at->top - LABEL_RISE) > LABEL_HEIGHT / 2.0) {
        double wide = WIDTH - LEFT - RIGHT, high = HEIGHT - TOP - BOTTOM;
        fprintf(script,
                "set arrow from graph %g,%g to graph %g,%g nohead lc rgb '#aaaaaa' lw 0.7\n",
                at->left / wide, at->top / high, (name->left - 1) / wide, middle / high);
    }
}

/** @return A name as enhanced text, bold or not, that stands in a script between single quotes. */
static const char *label_text(const ScatterPoint *point, char *text, size_t size) {
    char escaped[64] = "";
    size_t at = 0;
    for (const char *c = point->label; *c && at + 3 < sizeof escaped; c++) {
        if (strchr("^_{}@&~\\", *c)) {
            escaped[at++] = '\\';
        }
        escaped[at++] = *c;
    }
    char styled[80];
    snprintf(styled, sizeof styled, point->is_pareto ? "{/:Bold %s}" : "%s", escaped);
    return gnuplot_quote(styled, text, size);
}

/** Writes the names of a panel's points. */
static void write_point_labels(const ScatterPanel *panel, const AxisRange *ends, FILE *script) {
    LabelBox names[SCATTER_POINTS_MAXIMUM];
    double wide = WIDTH - LEFT - RIGHT, high = HEIGHT - TOP - BOTTOM;
    place_point_labels(panel, ends, names);
    for (size_t i = 0; i < panel->point_count; i++) {
        const ScatterPoint *point = &panel->points[i];
        LabelBox at = point_position(point, ends);
        char text[128];
        write_leader_line(&at, &names[i], script);
        fprintf(script, "set label '%s' at graph %g,%g left font ',12' textcolor rgb '%s'\n",
                label_text(point, text, sizeof text), names[i].left / wide,
                (names[i].bottom + names[i].top) / 2 / high, gnuplot_color(point->kind));
    }
}

/** @return Order of two points from the left, for qsort. */
static int compare_points(const void *a, const void *b) {
    double x = ((const ScatterPoint *)a)->x, y = ((const ScatterPoint *)b)->x;
    return (x > y) - (x < y);
}

/** Writes the line that joins the front. */
static void write_pareto_front(const ScatterPanel *panel, const AxisRange *ends, FILE *script) {
    ScatterPoint pareto_front[SCATTER_POINTS_MAXIMUM];
    size_t count = 0;
    for (size_t i = 0; i < panel->point_count; i++) {
        if (panel->points[i].is_pareto) {
            pareto_front[count++] = panel->points[i];
        }
    }
    qsort(pareto_front, count, sizeof *pareto_front, compare_points);
    for (size_t i = 1; i < count; i++) {
        fprintf(script,
                "set arrow from %.10g,%.10g to %.10g,%.10g nohead back lc rgb '#cccccc' lw 5\n",
                pareto_front[i - 1].x, fmax(pareto_front[i - 1].y, ends->y_low), pareto_front[i].x,
                fmax(pareto_front[i].y, ends->y_low));
    }
}

/** Writes the marks of x: 1, 2, 5 of each power of ten. */
static void write_x_ticks(const AxisRange *ends, FILE *script) {
    static const double marks[] = {1, 2, 5};
    const char *comma = "";
    fputs("set format x '%g'\nset xtics (", script);
    for (int power = (int)floor(log10(ends->x_low)); power <= log10(ends->x_high); power++) {
        for (size_t i = 0; i < sizeof marks / sizeof *marks; i++) {
            fprintf(script, "%s%.10g", comma, pow(10, power) * marks[i]);
            comma = ", ";
        }
    }
    fputs(")\n", script);
}

/** Writes the axes of a panel. */
static void write_axes(const Scatter *scatter, size_t index, const AxisRange *ends, FILE *script) {
    const ScatterPanel *panel = &scatter->panels[index];
    double wide = WIDTH * (double)scatter->panel_count, left = WIDTH * (double)index;
    char text[512];
    fprintf(script, "unset label\nunset arrow\nset title '%s' noenhanced font ',13'\n",
            gnuplot_quote(panel->title, text, sizeof text));
    fprintf(script, "set xlabel '%s' noenhanced\n",
            gnuplot_quote(scatter->x_label, text, sizeof text));
    fprintf(script, "set ylabel '%s' noenhanced font ',12' offset 1\n",
            gnuplot_quote(panel->y_label, text, sizeof text));
    fprintf(script,
            "set lmargin at screen %g\nset rmargin at screen %g\nset bmargin at screen %g\n"
            "set tmargin at screen %g\n",
            (left + LEFT) / wide, (left + WIDTH - RIGHT) / wide, (double)BOTTOM / HEIGHT,
            1 - (double)TOP / HEIGHT);
    fprintf(script, "set xrange [%g:%g]\nset yrange [%g:%g]\n", ends->x_low, ends->x_high,
            ends->y_low, ends->y_high);
    double decades = log10(ends->y_high / ends->y_low);
    fprintf(script, "set ytics %g\n", pow(10, fmax(1, ceil(decades / 10))));
    fprintf(script, ends->has_zero_floor ? "set ytics add ('0' %g)\n" : "# %g\n", ends->y_low);
    fprintf(script, "set key %s right font ',12' samplen 1\n",
            panel->is_fraction ? "center" : "top");
    write_x_ticks(ends, script);
}

/** Writes the points of a panel, with the spread of their x. */
static void write_points(const Scatter *scatter, const ScatterPanel *panel, const AxisRange *ends,
                         FILE *script) {
    fputs("plot ", script);
    for (size_t i = 0; i < scatter->kind_count; i++) {
        char kind[128];
        fprintf(script,
                "%sARG1 using %d:(strcol(%d) eq '%s' ? shown(column(%d), %g) : NaN):%d:%d with "
                "xerrorbars lc rgb '%s' pt %d ps 0.9 lw 1.5 title '%s'",
                i ? ", \\\n  " : "", scatter->x_columns[0], scatter->kind_column,
                gnuplot_quote(scatter->kinds[i], kind, sizeof kind), panel->y_column, ends->y_low,
                scatter->x_columns[1], scatter->x_columns[2], gnuplot_color((int)i),
                gnuplot_point_type((int)i), kind);
    }
    fputc('\n', script);
}

/** Writes the script of a chart. See #GnuplotJob.write_script. */
static void write_script(const void *chart, FILE *script) {
    const Scatter *scatter = chart;
    char text[256];
    fprintf(script,
            "set terminal svg size %zu,%d font 'sans-serif,14' background 'white'\n"
            "set output ARG2\nset datafile separator ','\nset datafile commentschars '#'\n"
            "set border 3 lw 1.2\nset tics nomirror out\nset grid lc rgb '#dddddd' lw 1 dt 1\n"
            "set logscale xy 10\nset format y "
            "'10^{%%L}'\nunset mxtics\nunset mytics\nset errorbars small\n"
            "shown(y, low) = y < low ? low : y\nset multiplot title '%s' noenhanced font ',14'\n",
            scatter->panel_count * WIDTH, HEIGHT, gnuplot_quote(scatter->title, text, sizeof text));
    for (size_t i = 0; i < scatter->panel_count; i++) {
        const ScatterPanel *panel = &scatter->panels[i];
        AxisRange ends = axis_range_of(panel);
        write_axes(scatter, i, &ends, script);
        write_pareto_front(panel, &ends, script);
        write_point_labels(panel, &ends, script);
        write_points(scatter, panel, &ends, script);
    }
    fputs("unset multiplot\n", script);
}

bool scatter_draw(const Scatter *scatter, const char *path, const atomic_bool *stop, Error *error) {
    return gnuplot_draw(&(GnuplotJob){scatter, write_script, scatter->csv}, path, stop, error);
}
