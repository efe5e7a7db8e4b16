/**
 * @file
 * @brief What is known of a scene's settings, as a table, as CSV, as a chart.
 */
#include "dioptre/chart.h"

#include "dioptre/language.h"
#include "lab/csv.h"
#include "lab/gnuplot.h"
#include "lab/plot.h"
#include "lab/table.h"

#include <libintl.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

/** Columns of the CSV that charts are drawn from. */
enum { COLUMN_SECONDS = 4, COLUMN_OWN = 7, COLUMN_TOTAL = 10 };

/** Prints a table. @param chart What is known. @param name The scene. @param stream Where to. */
static void chart_print(const Chart *chart, const char *name, FILE *stream) {
    static const char *const heads[] = {
        N_("setting"),   "",          N_("s/megapixel"), N_("from"),  N_("to"),
        N_("own error"), N_("steps"), N_("flips"),       N_("total"), N_("front")};
    Table table = table_of(sizeof heads / sizeof *heads, 2);
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        table_cell(&table, "%s", heads[i][0] ? gettext(heads[i]) : "");
    }
    for (size_t i = 0; i < chart->count; i++) {
        const ChartPoint *point = &chart->points[i];
        table_cell(&table, "%s", point->group);
        table_cell(&table, "%s", point->label);
        table_number(&table, point->seconds);
        table_number(&table, point->seconds_low);
        table_number(&table, point->seconds_high);
        table_number(&table, point->own);
        table_number(&table, point->steps);
        table_number(&table, point->flips);
        table_number(&table, point->total);
        table_cell(&table, "%s", point->is_front ? gettext("yes") : "");
    }
    fprintf(stream, "%s\n", name);
    table_print(&table, stream);
    table_release(&table);
}

/** Writes a setting's row. @param csv The table. @param group Its first cell. @param series Its
 *  second. @param point The setting. */
static void row_write(Csv *csv, const char *group, const char *series, const ChartPoint *point) {
    csv_word(csv, group);
    csv_word(csv, series);
    csv_word(csv, point->label);
    const double numbers[] = {point->seconds, point->seconds_low, point->seconds_high, point->own,
                              point->steps,   point->flips,       point->total};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        csv_number(csv, numbers[i]);
    }
    csv_end_row(csv);
}

/** A line of points. */
typedef struct Series {
    const ChartPoint *points[CHART_POINTS_MAXIMUM]; /**< The points. */
    double x[CHART_POINTS_MAXIMUM];                 /**< Their time. */
    double own[CHART_POINTS_MAXIMUM];               /**< Their own errors. */
    double total[CHART_POINTS_MAXIMUM];             /**< Their whole errors. */
    size_t count;                                   /**< How many. */
} Series;

/** Adds a point to a line. @param[in,out] series The line. @param point The point. */
static void series_add(Series *series, const ChartPoint *point) {
    series->points[series->count] = point;
    series->x[series->count] = point->seconds;
    series->own[series->count] = point->own;
    series->total[series->count] = point->total;
    series->count++;
}

/** @return Order of two settings by their time, for qsort. @param a One. @param b The other. */
static int compare_points(const void *a, const void *b) {
    double x = (*(const ChartPoint *const *)a)->seconds;
    double y = (*(const ChartPoint *const *)b)->seconds;
    return (x > y) - (x < y);
}

/** @return The front, the fastest first. @param chart What is known. */
static Series front_of(const Chart *chart) {
    Series front = {.count = 0}, sorted = {.count = 0};
    for (size_t i = 0; i < chart->count; i++) {
        if (chart->points[i].is_front) {
            series_add(&front, &chart->points[i]);
        }
    }
    qsort(front.points, front.count, sizeof *front.points, compare_points);
    for (size_t i = 0; i < front.count; i++) {
        series_add(&sorted, front.points[i]);
    }
    return sorted;
}

/** Writes the table. @param chart What is known. @param name The scene. @param path The file.
 *  @param[out] error What is wrong. @return Whether it is there. */
static bool chart_write(const Chart *chart, const char *name, const char *path, Error *error) {
    Csv csv;
    char title[256];
    snprintf(title, sizeof title, "%s: what settings cost and what errors they leave", name);
    if (!csv_begin(&csv, path, title, error)) {
        return false;
    }
    static const char *const heads[] = {"group",       "series",       "setting", "seconds",
                                        "seconds_low", "seconds_high", "own_rms", "own_steps",
                                        "flips",       "total_rms"};
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        csv_word(&csv, heads[i]);
    }
    csv_end_row(&csv);
    for (size_t i = 0; i < chart->count; i++) {
        row_write(&csv, chart->points[i].group, "all", &chart->points[i]);
    }
    Series front = front_of(chart);
    for (size_t i = 0; i < front.count; i++) {
        row_write(&csv, "front", "all", front.points[i]);
        row_write(&csv, "front", front.points[i]->label, front.points[i]);
    }
    return csv_commit(&csv, error);
}

/** @return The points of a group. @param chart What is known. @param[in,out] next The first point
 *  of the group; then of the next. */
static Series group_of(const Chart *chart, size_t *next) {
    Series series = {.count = 0};
    const char *group = chart->points[*next].group;
    while (*next < chart->count && strcmp(chart->points[*next].group, group) == 0) {
        series_add(&series, &chart->points[(*next)++]);
    }
    return series;
}

/** Most lines that are not of the front. */
enum { GROUPS_MAXIMUM = 8 };

/** What a chart is drawn of. */
typedef struct Drawn {
    Series groups[GROUPS_MAXIMUM]; /**< A line each. */
    size_t count;                  /**< How many. */
    Series front;                  /**< The front. */
    Plot plot;                     /**< Lines that point to all that. */
} Drawn;

/** Adds a line. @param[in,out] panel To it. @param label Its name. @param group First cell of its
 *  rows. @param series Their points. @param key Second cell. @param column Of its y. */
static void line_add(PlotPanel *panel, const char *label, const char *group, const char *key,
                     const Series *series, int column) {
    if (panel->count < PLOT_LINES_MAXIMUM) {
        panel->lines[panel->count] =
            (PlotLine){.label = label,
                       .keys = {group, key},
                       .column = column,
                       .x = series->x,
                       .y = column == COLUMN_OWN ? series->own : series->total,
                       .count = series->count,
                       .style = (int)panel->count};
        panel->count++;
    }
}

/** Lays out the chart. @param[out] drawn What it is drawn of. @param chart What is known.
 *  @param title Over it. @param csv Its table. */
static void chart_lay_out(Drawn *drawn, const Chart *chart, const char *title, const char *csv) {
    *drawn = (Drawn){.front = front_of(chart)};
    drawn->plot = (Plot){.title = title, .csv = csv, .count = 2, .columns = 2};
    PlotPanel *own = &drawn->plot.panels[0], *total = &drawn->plot.panels[1];
    *own = (PlotPanel){.title = "each error alone: rounding, model, noise",
                       .x_label = "CPU seconds a megapixel",
                       .y_label = "error, rms of linear light",
                       .x_column = COLUMN_SECONDS};
    *total = *own;
    total->title = "all errors together; the front, which nothing beats";
    for (size_t next = 0; next < chart->count && drawn->count < GROUPS_MAXIMUM;) {
        const char *group = chart->points[next].group;
        Series *series = &drawn->groups[drawn->count++];
        *series = group_of(chart, &next);
        line_add(own, group, group, "all", series, COLUMN_OWN);
        line_add(total, group, group, "all", series, COLUMN_TOTAL);
    }
    line_add(total, "front", "front", "all", &drawn->front, COLUMN_TOTAL);
    plot_share_range(own, 1);
    plot_share_range(total, 1);
}

/** Puts the front into words. @param chart What is known. @param name The scene.
 *  @param[out] title The words; cut to their size. @param size Bytes of them. */
static void front_say(const Chart *chart, const char *name, char *title, size_t size) {
    Series front = front_of(chart);
    snprintf(title, size, "%s; front:", name);
    for (size_t i = 0; i < front.count; i++) {
        size_t length = strlen(title);
        snprintf(title + length, size - length, "%s %s", i ? "," : "", front.points[i]->label);
    }
}

bool chart_keep(const Chart *chart, const char *name, const LabRequest *request, bool *has_chart,
                Error *error) {
    char csv[PATH_MAX], svg[PATH_MAX], title[200];
    int length = snprintf(csv, sizeof csv, "%s/%s.csv", request->folder, name);
    snprintf(svg, sizeof svg, "%.*s.svg", length > 4 ? length - 4 : 0, csv);
    *has_chart = gnuplot_is_there();
    if (request->table) {
        chart_print(chart, name, request->table);
    }
    if (length >= PATH_MAX) {
        return error_set(error, STATUS_FAILED, "the folder's name is too long");
    }
    Drawn drawn;
    front_say(chart, name, title, sizeof title);
    chart_lay_out(&drawn, chart, title, csv);
    return chart_write(chart, name, csv, error) &&
           (!*has_chart || plot_draw(&drawn.plot, svg, request->stop, error));
}
