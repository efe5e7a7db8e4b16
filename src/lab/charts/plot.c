/**
 * @file
 * @brief Writes gnuplot scripts of charts.
 */
#include "lab/charts/plot.h"

#include "lab/charts/gnuplot.h"
#include "lab/charts/plot_labels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Pixels of a panel of lines. */
enum { LINES_WIDTH = 470, LINES_HEIGHT = 380 };
/** Pixels of the title above panels of lines. */
enum { LINES_TITLE_HEIGHT = 40 };
/** Fraction of the x axis that is left for the names of lines. */
#define LINE_LABEL_WIDTH 0.30
/** Fraction of the x axis that is left for the name of the last point. */
#define POINT_LABEL_WIDTH 0.22

/** How many styles there are. */
enum { STYLE_COUNT = 8 };

/** @return The colour of a style, dark enough for paper. */
static const char *style_color(int style) {
    static const char *const colors[STYLE_COUNT] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                                    "#E69F00", "#56B4E9", "#7F7F7F", "#000000"};
    return colors[style % STYLE_COUNT];
}

/** @return The sign of a style, as gnuplot numbers them. */
static int style_point_type(int style) {
    static const int signs[STYLE_COUNT] = {7, 5, 9, 13, 4, 6, 8, 3};
    return signs[style % STYLE_COUNT];
}

/** @return A text for single quotes in a script. */
static const char *quoted(const char *text, char *buffer, size_t size) {
    size_t at = 0;
    for (; *text && at + 3 < size; text++) {
        if (*text == '\'') {
            buffer[at++] = '\'';
        }
        buffer[at++] = *text == '\n' ? ' ' : *text;
    }
    buffer[at] = '\0';
    return buffer;
}

/** Most letters of a line of a title: as many as a panel of points is wide. */
enum { TITLE_LETTERS = 92 };

/** @return A title for double quotes in a script, broken into lines at blanks. */
static const char *quoted_in_lines(const char *text, char *buffer, size_t size) {
    size_t at = 0, line = 0;
    for (; *text && at + 3 < size; text++, line++) {
        bool is_break = *text == ' ' && line + strcspn(text + 1, " ") >= TITLE_LETTERS;
        if (is_break || strchr("\"\\`", *text)) {
            buffer[at++] = '\\';
        }
        buffer[at++] = is_break ? 'n' : *text;
        line = is_break ? 0 : line;
    }
    buffer[at] = '\0';
    return buffer;
}

/* --- axes ----------------------------------------------------------------------------------------
 */

void plot_set_common_y_range(PlotPanel *panels, size_t count) {
    double low = INFINITY, high = 0;
    bool has_floor = false;
    for (size_t p = 0; p < count; p++) {
        for (size_t i = 0; i < panels[p].series_count; i++) {
            const PlotSeries *line = &panels[p].series[i];
            for (size_t n = 0; n < line->count; n++) {
                has_floor = has_floor || line->y[n] == 0;
                low = line->y[n] > 0 ? fmin(low, line->y[n]) : low;
                high = line->y[n] > 0 && isfinite(line->y[n]) ? fmax(high, line->y[n]) : high;
            }
        }
    }
    if (high == 0) {
        low = high = 1; // All values are zero.
    }
    for (size_t p = 0; p < count; p++) {
        panels[p].has_zero_floor = has_floor;
        panels[p].y_low = pow(10, floor(log10(low)) - has_floor);
        panels[p].y_high = pow(10, fmax(ceil(log10(high)), floor(log10(low)) + 1));
    }
}

/** @return The axes of a panel of lines. */
static PlotAxes line_axes(const PlotPanel *panel) {
    double low = INFINITY, high = 0;
    for (size_t i = 0; i < panel->series_count; i++) {
        for (size_t n = 0; n < panel->series[i].count; n++) {
            low = fmin(low, panel->series[i].x[n]);
            high = fmax(high, panel->series[i].x[n]);
        }
    }
    PlotAxes axes = {.x_first = panel->is_x_reversed ? high : low,
                     .x_last = panel->is_x_reversed ? low : high,
                     .y_low = panel->y_low,
                     .y_high = panel->y_high,
                     .has_zero_floor = panel->has_zero_floor};
    double range = axes.x_last / axes.x_first;
    axes.x_left = axes.x_first * pow(axes.x_first / axes.x_last, 0.03);
    axes.x_right = axes.x_last * pow(range, LINE_LABEL_WIDTH / (1 - LINE_LABEL_WIDTH));
    return axes;
}

/** @return The axes of a panel of points. @param panel With at least one point. */
static PlotAxes point_axes(const PlotPanel *panel) {
    PlotAxes axes = {.x_first = INFINITY, .y_low = INFINITY};
    for (size_t i = 0; i < panel->point_count; i++) {
        const PlotPoint *point = &panel->points[i];
        axes.x_first = fmin(axes.x_first, point->x);
        axes.x_last = fmax(axes.x_last, point->x);
        axes.has_zero_floor = axes.has_zero_floor || point->y == 0;
        axes.y_low = point->y > 0 ? fmin(axes.y_low, point->y) : axes.y_low;
        axes.y_high = fmax(axes.y_high, point->y);
    }
    if (axes.y_high == 0) {
        axes.y_low = axes.y_high = 1; // All values are zero.
    }
    double decades = fmax(log10(axes.x_last / axes.x_first), 0.3);
    axes.x_right = axes.x_first * pow(10, decades / (1 - POINT_LABEL_WIDTH));
    axes.x_left = axes.x_first / pow(10, 0.05 * decades);
    axes.y_low = pow(10, floor(log10(axes.y_low)) - axes.has_zero_floor);
    // The key needs room above all points, but no fraction exceeds 1.
    axes.y_high = pow(10, floor(log10(axes.y_high)) + 2);
    axes.y_high = panel->is_fraction ? fmin(axes.y_high, 1) : axes.y_high;
    return axes;
}

/**
 * Writes the ticks of an x axis from low to high.
 * @param has_mantissas  Whether 2 and 5 have ticks besides powers of ten.
 * @param step           Powers of ten from a tick to the next.
 */
static void write_x_ticks(double low, double high, bool has_mantissas, int step, FILE *script) {
    static const double mantissas[] = {1, 2, 5};
    const char *comma = "";
    fprintf(script, "set format x '%s'\nset xtics (", has_mantissas ? "%g" : "10^{%L}");
    for (int power = (int)floor(log10(low)); power <= log10(high); power += step) {
        for (size_t i = 0; i < (has_mantissas ? sizeof mantissas / sizeof *mantissas : 1); i++) {
            double at = pow(10, power) * mantissas[i];
            if (at >= low * 0.999 && at <= high * 1.001) {
                fprintf(script, "%s%.10g", comma, at);
                comma = ", ";
            }
        }
    }
    fputs(")\n", script);
}

/** Writes what the axes of all panels have. @param y_ticks Most ticks of y. */
static void write_ranges(const PlotAxes *axes, double y_ticks, FILE *script) {
    fprintf(script, "set xrange [%g:%g]\nset yrange [%g:%g]\n", axes->x_left, axes->x_right,
            axes->y_low, axes->y_high);
    double decades = log10(axes->y_high / axes->y_low);
    fprintf(script, "set ytics %g\n", pow(10, fmax(1, ceil(decades / y_ticks))));
    fprintf(script, axes->has_zero_floor ? "set ytics add ('0' %g)\n" : "# %g\n", axes->y_low);
}

/** Writes the titles of a panel. @param title_font, y_font Options of gnuplot. */
static void write_titles(const PlotPanel *panel, const char *title_font, const char *y_font,
                         FILE *script) {
    char text[512];
    fprintf(script, "set title \"%s\" noenhanced%s\n",
            quoted_in_lines(panel->title, text, sizeof text), title_font);
    fprintf(script, "set xlabel '%s' noenhanced\n", quoted(panel->x_label, text, sizeof text));
    fprintf(script, "set ylabel '%s' noenhanced%s\n", quoted(panel->y_label, text, sizeof text),
            y_font);
}

/* --- series --------------------------------------------------------------------------------------
 */

/** Writes the conditions that select a series' rows. */
static void write_row_condition(const PlotSeries *series, FILE *script) {
    const char *conjunction = "";
    for (size_t i = 0; i < sizeof series->keys / sizeof *series->keys; i++) {
        char value[128];
        if (series->keys[i].value) {
            fprintf(script, "%sstrcol(%d) eq '%s'", conjunction, series->keys[i].column,
                    quoted(series->keys[i].value, value, sizeof value));
            conjunction = " && ";
        }
    }
}

/** Writes the series of a panel. */
static void write_series(const Plot *plot, const PlotPanel *panel, const PlotAxes *axes,
                         FILE *script) {
    bool is_lines = plot->kind == PLOT_LINES;
    fputs("plot ", script);
    for (size_t i = 0; i < panel->series_count; i++) {
        const PlotSeries *series = &panel->series[i];
        char label[128];
        fprintf(script, "%sARG1 using %d:(", i ? ", \\\n  " : "", panel->x_columns[0]);
        write_row_condition(series, script);
        fprintf(script, " ? shown(column(%d), %g) : NaN)", series->y_column, axes->y_low);
        if (!is_lines) {
            fprintf(script, ":%d:%d", panel->x_columns[1], panel->x_columns[2]);
        }
        fprintf(script, " with %s lc rgb '%s' pt %d %s", is_lines ? "linespoints" : "xerrorbars",
                style_color(series->style), style_point_type(series->style),
                is_lines ? "ps 0.7 lw 2" : "ps 0.9 lw 1.5");
        if (!is_lines) {
            fprintf(script, " title '%s'", quoted(series->label, label, sizeof label));
        }
    }
    fputc('\n', script);
}

/** Writes the names of a panel's lines. */
static void write_line_labels(const PlotPanel *panel, const PlotAxes *axes, FILE *script) {
    LineLabel labels[PLOT_SERIES_MAXIMUM];
    size_t count = plot_line_labels(panel, axes, labels);
    double x = axes->x_last * pow(axes->x_last / axes->x_first, 0.03);
    double low = log10(axes->y_low), high = log10(axes->y_high);
    fputs("unset label\n", script);
    for (size_t i = 0; i < count; i++) {
        char text[128];
        fprintf(script, "set label %zu '%s' at %g, %g left noenhanced textcolor rgb '%s'\n", i + 1,
                quoted(labels[i].series->label, text, sizeof text), x,
                pow(10, low + labels[i].height * (high - low)),
                style_color(labels[i].series->style));
    }
}

/** @return A point's name as enhanced text for single quotes, bold on the Pareto front. */
static const char *point_label_text(const PlotPoint *point, char *text, size_t size) {
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
    return quoted(styled, text, size);
}

/** Writes the names of a panel's points, and lines to those that stand elsewhere. */
static void write_point_labels(const PlotPanel *panel, const PlotAxes *axes, FILE *script) {
    LabelBox labels[PLOT_POINTS_MAXIMUM];
    const double wide = POINTS_INNER_WIDTH, high = POINTS_INNER_HEIGHT;
    plot_point_labels(panel, axes, labels);
    for (size_t i = 0; i < panel->point_count; i++) {
        const PlotPoint *point = &panel->points[i];
        LabelBox at = plot_point_position(point, axes);
        double middle = (labels[i].bottom + labels[i].top) / 2;
        char text[128];
        if (plot_label_is_displaced(&at, &labels[i])) {
            fprintf(script,
                    "set arrow from graph %g,%g to graph %g,%g nohead lc rgb '#aaaaaa' lw 0.7\n",
                    at.left / wide, at.top / high,
                    (labels[i].left > at.left ? labels[i].left - 1 : labels[i].right + 1) / wide,
                    middle / high);
        }
        fprintf(script, "set label '%s' at graph %g,%g left font ',12' textcolor rgb '%s'\n",
                point_label_text(point, text, sizeof text), labels[i].left / wide, middle / high,
                style_color(point->style));
    }
}

/** @return Order of two points from the left, for qsort. */
static int compare_points(const void *a, const void *b) {
    double x = ((const PlotPoint *)a)->x, y = ((const PlotPoint *)b)->x;
    return (x > y) - (x < y);
}

/** Writes the line that joins the Pareto front. */
static void write_pareto_front(const PlotPanel *panel, const PlotAxes *axes, FILE *script) {
    PlotPoint front[PLOT_POINTS_MAXIMUM];
    size_t count = 0;
    for (size_t i = 0; i < panel->point_count; i++) {
        if (panel->points[i].is_pareto) {
            front[count++] = panel->points[i];
        }
    }
    qsort(front, count, sizeof *front, compare_points);
    for (size_t i = 1; i < count; i++) {
        fprintf(script,
                "set arrow from %.10g,%.10g to %.10g,%.10g nohead back lc rgb '#cccccc' lw 5\n",
                front[i - 1].x, fmax(front[i - 1].y, axes->y_low), front[i].x,
                fmax(front[i].y, axes->y_low));
    }
}

/* --- panels --------------------------------------------------------------------------------------
 */

/** Writes a panel of lines. */
static void write_line_panel(const Plot *plot, size_t index, FILE *script) {
    const PlotPanel *panel = &plot->panels[index];
    PlotAxes axes = line_axes(panel);
    double low = fmin(axes.x_first, axes.x_last), high = fmax(axes.x_first, axes.x_last);
    double decades = log10(high / low);
    write_titles(panel, "", "", script);
    write_ranges(&axes, 9, script);
    write_x_ticks(low, high, decades <= 2.5, decades > 7 ? 2 : 1, script); // None under the names.
    write_line_labels(panel, &axes, script);
    write_series(plot, panel, &axes, script);
}

/** Writes a panel of points. */
static void write_point_panel(const Plot *plot, size_t index, FILE *script) {
    const PlotPanel *panel = &plot->panels[index];
    PlotAxes axes = point_axes(panel);
    double wide = POINTS_WIDTH * (double)plot->panel_count, left = POINTS_WIDTH * (double)index;
    fputs("unset label\nunset arrow\n", script);
    write_titles(panel, " font ',12'", " font ',12' offset 1", script);
    fprintf(script,
            "set lmargin at screen %g\nset rmargin at screen %g\nset bmargin at screen %g\n"
            "set tmargin at screen %g\n",
            (left + POINTS_LEFT) / wide, (left + POINTS_WIDTH - POINTS_RIGHT) / wide,
            (double)POINTS_BOTTOM / POINTS_HEIGHT, 1 - (double)POINTS_TOP / POINTS_HEIGHT);
    write_ranges(&axes, 10, script);
    fprintf(script, "set key %s right font ',12' samplen 1\n",
            panel->is_fraction ? "center" : "top");
    write_x_ticks(axes.x_left, axes.x_right, true, 1, script);
    write_pareto_front(panel, &axes, script);
    write_point_labels(panel, &axes, script);
    write_series(plot, panel, &axes, script);
}

/** Writes a script. */
static void write_script(const Plot *plot, FILE *script) {
    size_t rows = (plot->panel_count + plot->columns - 1) / plot->columns;
    bool is_lines = plot->kind == PLOT_LINES;
    char title[256];
    quoted(plot->title, title, sizeof title);
    fprintf(script, "set terminal svg size %zu,%zu font 'sans-serif,14' background 'white'\n",
            plot->columns * (is_lines ? LINES_WIDTH : POINTS_WIDTH),
            is_lines ? rows * LINES_HEIGHT + LINES_TITLE_HEIGHT : rows * POINTS_HEIGHT);
    fprintf(script,
            "set output ARG2\nset datafile separator ','\nset datafile commentschars '#'\n"
            "%sset border 3 lw 1.2\nset tics nomirror out\nset grid lc rgb '#dddddd' lw 1 dt 1\n"
            "%sset logscale xy 10\nset format y '10^{%%L}'\nunset mxtics\nunset mytics\n"
            "%sshown(y, low) = y < low ? low : y\n",
            is_lines ? "set datafile missing NaN\n" : "", is_lines ? "unset key\n" : "",
            is_lines ? "" : "set errorbars small\n");
    if (is_lines) {
        fprintf(script, "set multiplot layout %zu,%zu title '%s' noenhanced font ',16'\n", rows,
                plot->columns, title);
    } else {
        fprintf(script, "set multiplot title '%s' noenhanced font ',14'\n", title);
    }
    for (size_t i = 0; i < plot->panel_count; i++) {
        (is_lines ? write_line_panel : write_point_panel)(plot, i, script);
    }
    fputs("unset multiplot\n", script);
}

bool plot_draw(const Plot *plot, const char *path, const atomic_bool *stop, Error *error) {
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    if (!stream) {
        return error_set(error, STATUS_FAILED, "no memory for a chart");
    }
    write_script(plot, stream);
    bool is_drawn = fclose(stream) == 0
                        ? gnuplot_run(&(GnuplotScript){text, size, plot->csv}, path, stop, error)
                        : error_set(error, STATUS_FAILED, "no memory for a chart");
    free(text);
    return is_drawn;
}
