/**
 * @file
 * @brief Charts, drawn by gnuplot.
 */
#include "lab/charts/plot.h"

#include "lab/charts/gnuplot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/** Pixels of a panel. */
enum { PANEL_WIDTH = 470, PANEL_HEIGHT = 380 };
/** Share of a panel's width that is left for the names of lines. */
#define LABEL_WIDTH_FRACTION 0.30
/** Least distance between two names, as a share of a panel's height. */
#define LABEL_HEIGHT 0.055

/** Numbers before which a panel has marks, within a power of ten. */
static const double tick_mantissas[] = {1, 2, 5};

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
        low = high = 1; // All of it is zero.
    }
    for (size_t p = 0; p < count; p++) {
        panels[p].has_zero_floor = has_floor;
        panels[p].y_low = pow(10, floor(log10(low)) - has_floor);
        panels[p].y_high = pow(10, fmax(ceil(log10(high)), floor(log10(low)) + 1));
    }
}

/** The name of a line, on its way to its place. */
typedef struct SeriesLabel {
    const PlotSeries *series; /**< The line. */
    double height;            /**< Where, 0 at the bottom to 1 at the top. */
} SeriesLabel;

/** @return Order of two names from the bottom, for qsort. */
static int compare_series_labels(const void *a, const void *b) {
    double x = ((const SeriesLabel *)a)->height, y = ((const SeriesLabel *)b)->height;
    return (x > y) - (x < y);
}

/** @return Where on a panel a value is, 0 at the bottom to 1 at the top. */
static double relative_height(const PlotPanel *panel, double y) {
    double low = log10(panel->y_low), high = log10(panel->y_high);
    double at = (log10(fmin(fmax(y, panel->y_low), panel->y_high)) - low) / (high - low);
    return fmin(fmax(at, 0), 1);
}

/** Moves names apart that would overlap: upwards from the bottom, then back from the top. */
static void spread_series_labels(SeriesLabel *names, size_t count) {
    qsort(names, count, sizeof *names, compare_series_labels);
    if (count > 0) {
        names[0].height = fmax(names[0].height, LABEL_HEIGHT / 2); // Not into the axis.
    }
    for (size_t i = 1; i < count; i++) {
        names[i].height = fmax(names[i].height, names[i - 1].height + LABEL_HEIGHT);
    }
    double top = 1;
    for (size_t i = count; i-- > 0; top = names[i].height - LABEL_HEIGHT) {
        names[i].height = fmin(names[i].height, top);
    }
}

/** Finds where the names of a panel's lines go. @return How many. */
static size_t place_series_labels(const PlotPanel *panel, SeriesLabel names[PLOT_SERIES_MAXIMUM]) {
    size_t count = 0;
    for (size_t i = 0; i < panel->series_count; i++) {
        const PlotSeries *line = &panel->series[i];
        size_t last = line->count;
        while (last > 0 && isnan(line->y[last - 1])) {
            last--;
        }
        if (last > 0) {
            names[count++] = (SeriesLabel){line, relative_height(panel, line->y[last - 1])};
        }
    }
    spread_series_labels(names, count);
    return count;
}

/** The ends of a panel's x. */
typedef struct XRange {
    double first;     /**< At the left. */
    double last;      /**< Of the lines, where their names begin. */
    double panel_end; /**< Of the panel, at the right. */
} XRange;

/** @return The ends of x. */
static XRange find_x_range(const PlotPanel *panel) {
    double low = INFINITY, high = 0;
    for (size_t i = 0; i < panel->series_count; i++) {
        for (size_t n = 0; n < panel->series[i].count; n++) {
            low = fmin(low, panel->series[i].x[n]);
            high = fmax(high, panel->series[i].x[n]);
        }
    }
    XRange ends = panel->is_x_reversed ? (XRange){high, low, 0} : (XRange){low, high, 0};
    double stretch = LABEL_WIDTH_FRACTION / (1 - LABEL_WIDTH_FRACTION);
    ends.panel_end = ends.last * pow(ends.last / ends.first, stretch);
    return ends;
}

/** Writes the names of a panel's lines. @param ends The ends of its x. */
static void write_series_labels(const PlotPanel *panel, const XRange *ends, FILE *script) {
    SeriesLabel names[PLOT_SERIES_MAXIMUM];
    size_t count = place_series_labels(panel, names);
    double x = ends->last * pow(ends->last / ends->first, 0.03);
    fputs("unset label\n", script);
    for (size_t i = 0; i < count; i++) {
        char text[128];
        double low = log10(panel->y_low), high = log10(panel->y_high);
        fprintf(script, "set label %zu '%s' at %g, %g left noenhanced textcolor rgb '%s'\n", i + 1,
                gnuplot_quote(names[i].series->label, text, sizeof text), x,
                pow(10, low + names[i].height * (high - low)),
                gnuplot_color(names[i].series->style));
    }
}

/** Writes the marks of a panel's x: powers of ten, or 1, 2, 5 where it is short; none under the
 *  names of lines. */
static void write_x_ticks(const XRange *ends, FILE *script) {
    double low = fmin(ends->first, ends->last), high = fmax(ends->first, ends->last);
    double wide = log10(high / low);
    int step = wide > 7 ? 2 : 1;
    size_t count = wide > 2.5 ? 1 : sizeof tick_mantissas / sizeof *tick_mantissas;
    fprintf(script, "set format x '%s'\nset xtics (", count == 1 ? "10^{%L}" : "%g");
    const char *comma = "";
    for (int power = (int)floor(log10(low)); power <= log10(high); power += step) {
        for (size_t i = 0; i < count; i++) {
            double at = pow(10, power) * tick_mantissas[i];
            if (at >= low * 0.999 && at <= high * 1.001) {
                fprintf(script, "%s%.10g", comma, at);
                comma = ", ";
            }
        }
    }
    fputs(")\n", script);
}

/** Writes the axes of a panel. @param ends The ends of its x. */
static void write_axes(const PlotPanel *panel, const XRange *ends, FILE *script) {
    char text[256];
    fprintf(script, "set title '%s' noenhanced\n", gnuplot_quote(panel->title, text, sizeof text));
    fprintf(script, "set xlabel '%s' noenhanced\n",
            gnuplot_quote(panel->x_label, text, sizeof text));
    fprintf(script, "set ylabel '%s' noenhanced\n",
            gnuplot_quote(panel->y_label, text, sizeof text));
    double left = ends->first * pow(ends->first / ends->last, 0.03);
    fprintf(script, "set xrange [%g:%g]\nset yrange [%g:%g]\n", left, ends->panel_end, panel->y_low,
            panel->y_high);
    double decades = log10(panel->y_high / panel->y_low);
    fprintf(script, "set ytics %g\n", pow(10, fmax(1, ceil(decades / 9))));
    fprintf(script, panel->has_zero_floor ? "set ytics add ('0' %g)\n" : "# %g\n", panel->y_low);
    write_x_ticks(ends, script);
}

/** Writes a panel's lines. */
static void write_lines(const PlotPanel *panel, FILE *script) {
    fputs("plot ", script);
    for (size_t i = 0; i < panel->series_count; i++) {
        const PlotSeries *line = &panel->series[i];
        char first[128], second[128];
        fprintf(script,
                "%sARG1 using %d:(strcol(1) eq '%s' && strcol(2) eq '%s' ? shown(column(%d), %g) "
                ": NaN) with linespoints lc rgb '%s' pt %d ps 0.7 lw 2",
                i ? ", \\\n  " : "", panel->x_column,
                gnuplot_quote(line->row_keys[0], first, sizeof first),
                gnuplot_quote(line->row_keys[1], second, sizeof second), line->y_column,
                panel->y_low, gnuplot_color(line->style), gnuplot_point_type(line->style));
    }
    fputc('\n', script);
}

/** Writes the script of a chart. See #GnuplotJob.write_script. */
static void write_script(const void *chart, FILE *script) {
    const Plot *plot = chart;
    size_t rows = (plot->panel_count + plot->columns - 1) / plot->columns;
    char text[256];
    fprintf(
        script,
        "set terminal svg size %zu,%zu font 'sans-serif,14' background 'white'\n"
        "set output ARG2\nset datafile separator ','\nset datafile commentschars '#'\n"
        "set datafile missing NaN\nset border 3 lw 1.2\nset tics nomirror out\n"
        "set grid lc rgb '#dddddd' lw 1 dt 1\nunset key\nset logscale xy 10\n"
        "set format y '10^{%%L}'\nunset mxtics\nunset mytics\nshown(y, low) = y < low ? low : y\n"
        "set multiplot layout %zu,%zu title '%s' noenhanced font ',16'\n",
        plot->columns * PANEL_WIDTH, rows * PANEL_HEIGHT + 40, rows, plot->columns,
        gnuplot_quote(plot->title, text, sizeof text));
    for (size_t i = 0; i < plot->panel_count; i++) {
        const PlotPanel *panel = &plot->panels[i];
        XRange ends = find_x_range(panel);
        write_axes(panel, &ends, script);
        write_series_labels(panel, &ends, script);
        write_lines(panel, script);
    }
    fputs("unset multiplot\n", script);
}

bool plot_draw(const Plot *plot, const char *path, const atomic_bool *stop, Error *error) {
    return gnuplot_draw(&(GnuplotJob){plot, write_script, plot->csv}, path, stop, error);
}
