/**
 * @file
 * @brief What the settings of a scene cost and leave of errors, as a table, as CSV, as a chart.
 */
#include "lab/charts/chart.h"

#include "base/language.h"
#include "base/sanitize.h"
#include "lab/charts/csv.h"
#include "lab/charts/gnuplot.h"
#include "lab/charts/plot.h"
#include "lab/charts/table.h"

#include <libintl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

/** Columns of the CSV that charts are drawn from. */
enum { COLUMN_GROUP = 1, COLUMN_SERIES, COLUMN_SECONDS = 4, COLUMN_OWN = 7, COLUMN_TOTAL = 10 };
/** Numbers of a row: times and errors. */
enum { ROW_NUMBERS = 8 };

/** Lists the numbers of a row, as the table and the CSV have them. */
static void row_numbers(const ChartPoint *point, double numbers[ROW_NUMBERS]) {
    const double values[ROW_NUMBERS] = {
        point->seconds,   point->seconds_low,        point->seconds_high, point->own_error,
        point->max_steps, point->edge_flip_fraction, point->total_error,  point->rounding_fraction};
    memcpy(numbers, values, sizeof values);
}

/** Prints a table. */
static void chart_print_table(const Chart *chart, const char *name, FILE *stream) {
    static const char *const columns[] = {N_("setting"),   "",          N_("s/megapixel"),
                                          N_("from"),      N_("to"),    N_("own error"),
                                          N_("max steps"), N_("flips"), N_("total"),
                                          N_("rounding"),  N_("front")};
    Table table = table_make(sizeof columns / sizeof *columns, 2);
    table_heading(&table, columns);
    for (size_t i = 0; i < chart->count; i++) {
        const ChartPoint *point = &chart->points[i];
        double numbers[ROW_NUMBERS];
        row_numbers(point, numbers);
        table_cell(&table, "%s", point->setting);
        table_cell(&table, "%s", point->label);
        for (size_t n = 0; n < ROW_NUMBERS; n++) {
            table_number(&table, numbers[n]);
        }
        table_cell(&table, "%s", point->is_pareto ? gettext("yes") : "");
    }
    fprintf(stream, "%s\n", name);
    table_print(&table, stream);
    table_deinit(&table);
}

/** Writes a setting's row. */
static void write_csv_row(Csv *csv, const char *group, const char *series,
                          const ChartPoint *point) {
    double numbers[ROW_NUMBERS];
    row_numbers(point, numbers);
    csv_text(csv, group);
    csv_text(csv, series);
    csv_text(csv, point->label);
    csv_numbers(csv, numbers, ROW_NUMBERS);
}

/** Points that a line joins. */
typedef struct Series {
    const ChartPoint *points[CHART_POINTS_MAXIMUM]; /**< The points. */
    double x[CHART_POINTS_MAXIMUM];                 /**< Their times. */
    double own_error[CHART_POINTS_MAXIMUM];         /**< Their own errors. */
    double total_error[CHART_POINTS_MAXIMUM];       /**< Their total errors. */
    size_t count;                                   /**< Number of #points. */
} Series;

/** Adds a point to a line. */
static void series_add(Series *series, const ChartPoint *point) {
    series->points[series->count] = point;
    series->x[series->count] = point->seconds;
    series->own_error[series->count] = point->own_error;
    series->total_error[series->count] = point->total_error;
    series->count++;
}

/** @return Order of two settings by their time, for qsort. */
static int compare_points(const void *a, const void *b) {
    double x = (*(const ChartPoint *const *)a)->seconds;
    double y = (*(const ChartPoint *const *)b)->seconds;
    return (x > y) - (x < y);
}

/** @return The Pareto front, the fastest first. */
static Series pareto_front_of(const Chart *chart) {
    Series pareto_front = {.count = 0};
    const ChartPoint *sorted[CHART_POINTS_MAXIMUM];
    size_t count = 0;
    for (size_t i = 0; i < chart->count; i++) {
        if (chart->points[i].is_pareto) {
            sorted[count++] = &chart->points[i];
        }
    }
    qsort(sorted, count, sizeof *sorted, compare_points);
    for (size_t i = 0; i < count; i++) {
        series_add(&pareto_front, sorted[i]);
    }
    return pareto_front;
}

/** Writes the CSV. @return Whether it is written. */
static bool chart_write_csv(const Chart *chart, const char *name, const char *path, Error *error) {
    static const char *const columns[] = {"group",       "series",       "setting", "seconds",
                                          "seconds_low", "seconds_high", "own_rms", "own_steps",
                                          "flips",       "total_rms",    "rounding"};
    Csv csv;
    char title[256];
    snprintf(title, sizeof title, "%s: what settings cost and what errors they leave", name);
    if (!csv_begin(&csv, path, title, error)) {
        return false;
    }
    csv_heading(&csv, columns, sizeof columns / sizeof *columns);
    for (size_t i = 0; i < chart->count; i++) {
        write_csv_row(&csv, chart->points[i].setting, "all", &chart->points[i]);
    }
    Series pareto_front = pareto_front_of(chart);
    for (size_t i = 0; i < pareto_front.count; i++) {
        write_csv_row(&csv, "front", "all", pareto_front.points[i]);
        write_csv_row(&csv, "front", pareto_front.points[i]->label, pareto_front.points[i]);
    }
    return csv_commit(&csv, error);
}

/** @return The points of a group. @param[in,out] next Its first point; then that of the next. */
static Series take_group_series(const Chart *chart, size_t *next) {
    Series series = {.count = 0};
    const char *group = chart->points[*next].setting;
    while (*next < chart->count && strcmp(chart->points[*next].setting, group) == 0) {
        series_add(&series, &chart->points[(*next)++]);
    }
    return series;
}

/** Most lines besides the Pareto front. */
enum { GROUP_SERIES_MAXIMUM = 8 };

/** A chart, and the numbers in it. */
typedef struct SettingsChart {
    Series group_series[GROUP_SERIES_MAXIMUM]; /**< A line per group of settings. */
    size_t group_count;                        /**< Number of #group_series. */
    Series pareto_front;                       /**< The Pareto front. */
    Plot plot;                                 /**< The chart, which points to all that. */
} SettingsChart;

/** Adds a line. @param group First cell of its rows. @param column Of y. */
static void panel_add_series(PlotPanel *panel, const char *group, const Series *series,
                             int column) {
    if (panel->series_count < PLOT_SERIES_MAXIMUM) {
        panel->series[panel->series_count] =
            (PlotSeries){.label = group,
                         .keys = {{COLUMN_GROUP, group}, {COLUMN_SERIES, "all"}},
                         .y_column = column,
                         .x = series->x,
                         .y = column == COLUMN_OWN ? series->own_error : series->total_error,
                         .count = series->count,
                         .style = (int)panel->series_count};
        panel->series_count++;
    }
}

/** Makes a chart. @param csv Path of its table. */
static void settings_chart_init(SettingsChart *layout, const Chart *chart, const char *title,
                                const char *csv) {
    *layout = (SettingsChart){.pareto_front = pareto_front_of(chart)};
    layout->plot = (Plot){.title = title, .csv = csv, .panel_count = 2, .columns = 2};
    PlotPanel *own = &layout->plot.panels[0], *total = &layout->plot.panels[1];
    *own = (PlotPanel){.title = "each error alone: rounding, model, noise",
                       .x_label = "CPU seconds a megapixel",
                       .y_label = "error, rms of linear light",
                       .x_columns = {COLUMN_SECONDS}};
    *total = *own;
    total->title = "all errors together; the front, which nothing beats";
    for (size_t next = 0; next < chart->count && layout->group_count < GROUP_SERIES_MAXIMUM;) {
        const char *group = chart->points[next].setting;
        Series *series = &layout->group_series[layout->group_count++];
        *series = take_group_series(chart, &next);
        panel_add_series(own, group, series, COLUMN_OWN);
        panel_add_series(total, group, series, COLUMN_TOTAL);
    }
    panel_add_series(total, "front", &layout->pareto_front, COLUMN_TOTAL);
    plot_set_common_y_range(own, 1);
    plot_set_common_y_range(total, 1);
}

/** Lists the Pareto front. @param[out] title The list; cut to its size. */
static void write_pareto_caption(const Chart *chart, const char *name, char *title, size_t size) {
    Series pareto_front = pareto_front_of(chart);
    snprintf(title, size, "%s; front:", name);
    for (size_t i = 0; i < pareto_front.count; i++) {
        size_t length = strlen(title);
        snprintf(title + length, size - length, "%s %s", i ? "," : "",
                 pareto_front.points[i]->label);
    }
}

bool chart_save(const Chart *chart, const char *name, const LabRequest *request, bool *has_chart,
                Error *error) {
    char csv[PATH_MAX], svg[PATH_MAX], title[200], shown_name[160];
    int length = snprintf(csv, sizeof csv, "%s/%s.csv", request->folder, name);
    snprintf(svg, sizeof svg, "%.*s.svg", length > 4 ? length - 4 : 0, csv);
    sanitize_line(shown_name, sizeof shown_name, name);
    *has_chart = gnuplot_is_available();
    if (request->table_stream) {
        chart_print_table(chart, shown_name, request->table_stream);
    }
    if (length >= PATH_MAX) {
        return error_set(error, STATUS_FAILED, "the folder's name is too long");
    }
    SettingsChart layout;
    write_pareto_caption(chart, shown_name, title, sizeof title);
    settings_chart_init(&layout, chart, title, csv);
    return chart_write_csv(chart, shown_name, csv, error) &&
           (!*has_chart || plot_draw(&layout.plot, svg, request->stop, error));
}
