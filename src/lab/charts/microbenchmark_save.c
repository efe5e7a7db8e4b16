/**
 * @file
 * @brief Speed and accuracy of methods, as a table, as CSV, as a chart.
 */
#include "lab/microbenchmark.h"

#include "base/language.h"
#include "base/pareto_front.h"
#include "lab/charts/csv.h"
#include "lab/charts/gnuplot.h"
#include "lab/charts/plot.h"
#include "lab/charts/table.h"

#include <libintl.h>
#include <limits.h>
#include <math.h>
#include <string.h>

/** Columns of the CSV that charts are drawn from. */
enum { COLUMN_TYPE = 2, COLUMN_NS = 4, COLUMN_ERROR = 7, COLUMN_FAILURES = 9 };
/** Most panels: errors and failures. */
enum { PANELS_MAXIMUM = 2 };
/** Longest title of a panel, bytes with its final zero. */
enum { TITLE_SIZE = 400 };
/** Longest label of an axis, bytes with its final zero. */
enum { LABEL_SIZE = 160 };
/** Numbers of a row: times, errors, failures, double hits. */
enum { ROW_NUMBERS = 7 };

/** @return A method's error; NaN: none is measured. */
static double point_error_p999(const MicrobenchmarkPoint *point) {
    return point->result.p999;
}

/** @return The fraction of a method's failures; NaN: none is counted. */
static double point_failures(const MicrobenchmarkPoint *point) {
    return point->result.failure_fraction;
}

/** A chart, and the text in it. */
typedef struct BenchmarkChart {
    Plot plot;                                     /**< The chart. */
    char titles[PANELS_MAXIMUM][TITLE_SIZE];       /**< Of its panels. */
    char y_labels[PANELS_MAXIMUM][LABEL_SIZE];     /**< Of their y axes. */
    char x_label[LABEL_SIZE];                      /**< Of all x axes. */
    bool is_pareto[MICROBENCHMARK_POINTS_MAXIMUM]; /**< Whether each is part of a panel's front. */
    bool is_tied[MICROBENCHMARK_POINTS_MAXIMUM];   /**< Whether it is tied with one there. */
} BenchmarkChart;

/** @return The index of a number type. */
static int type_index(const char *name) {
    int index = 0;
    while (strcmp(number_types()[index]->name, name) != 0) {
        index++;
    }
    return index;
}

/** @return How many number types are drawn: all but quad, which is the reference of the others. */
static size_t plotted_type_count(void) {
    size_t count = 0;
    while (number_types()[count + 1]) {
        count++;
    }
    return count;
}

/** Lists points of the front of a panel. @param before Stands before the first of them. @param
 *  is_tied Whether those are listed that are tied with others. */
static void append_to_caption(const PlotPanel *panel, const ParetoPoint *points, const char *before,
                              bool is_tied, char title[TITLE_SIZE]) {
    for (size_t i = 0; i < panel->point_count; i++) {
        const PlotPoint *point = &panel->points[i];
        size_t length = strlen(title);
        if (points[i].is_pareto && points[i].is_tied == is_tied) {
            snprintf(title + length, TITLE_SIZE - length, "%s%s %s", before, point->label,
                     number_types()[point->style]->name);
            before = ", ";
        }
    }
}

/**
 * Marks the Pareto front of a panel and lists it in the title.
 * @param rows  For each point, its index in the benchmark.
 * @param title  Receives the list; must live as long as the chart.
 */
static void mark_pareto_front(BenchmarkChart *chart, const Microbenchmark *benchmark,
                              PlotPanel *panel, const size_t *rows, char title[TITLE_SIZE]) {
    ParetoPoint points[PLOT_POINTS_MAXIMUM];
    for (size_t i = 0; i < panel->point_count; i++) {
        const Quartiles *ns = &benchmark->points[rows[i]].ns;
        points[i] = (ParetoPoint){.cost = panel->points[i].x,
                                  .error = panel->points[i].y,
                                  .cost_low = ns->low,
                                  .cost_high = ns->high};
    }
    pareto_front_find(points, panel->point_count, 1);
    for (size_t i = 0; i < panel->point_count; i++) {
        panel->points[i].is_pareto = points[i].is_pareto;
        bool is_untied = points[i].is_pareto && !points[i].is_tied;
        chart->is_pareto[rows[i]] = chart->is_pareto[rows[i]] || is_untied;
        chart->is_tied[rows[i]] = chart->is_tied[rows[i]] || points[i].is_tied;
    }
    title[0] = '\0';
    append_to_caption(panel, points, "front: ", false, title);
    append_to_caption(panel, points, "; tied: ", true, title);
}

/** Adds a panel, unless all of its values are 0 or missing. @param column Of y. */
static void benchmark_chart_add_panel(BenchmarkChart *chart, const Microbenchmark *benchmark,
                                      double (*y_of)(const MicrobenchmarkPoint *point),
                                      int column) {
    size_t index = chart->plot.panel_count, rows[PLOT_POINTS_MAXIMUM];
    PlotPanel *panel = &chart->plot.panels[index];
    double sum = 0;
    *panel = (PlotPanel){.title = chart->titles[index],
                         .x_label = chart->x_label,
                         .y_label = chart->y_labels[index],
                         .x_columns = {COLUMN_NS, COLUMN_NS + 1, COLUMN_NS + 2},
                         .series_count = plotted_type_count(),
                         .is_fraction = column == COLUMN_FAILURES};
    for (size_t i = 0; i < panel->series_count; i++) {
        const char *type = number_types()[i]->name;
        panel->series[i] = (PlotSeries){
            .label = type, .keys = {{COLUMN_TYPE, type}}, .y_column = column, .style = (int)i};
    }
    for (size_t i = 0; i < benchmark->count; i++) {
        const MicrobenchmarkPoint *point = &benchmark->points[i];
        int type = type_index(point->result.type);
        double y = y_of(point);
        if (type < (int)panel->series_count && !isnan(y)) {
            rows[panel->point_count] = i;
            panel->points[panel->point_count++] = (PlotPoint){
                .label = point->result.label, .x = point->ns.median, .y = y, .style = type};
            sum += y;
        }
    }
    if (sum > 0) {
        mark_pareto_front(chart, benchmark, panel, rows, chart->titles[index]);
        chart->plot.panel_count++;
        chart->plot.columns++;
    }
}

/** Writes the label of the x axis: the time, and the level of difficulty it is measured at. */
static void write_x_label(const Experiment *experiment, char label[LABEL_SIZE]) {
    static const char *const time = "nanoseconds per test, one thread";
    if (experiment->timed_level > 0) {
        snprintf(label, LABEL_SIZE, "%s; %s: %g", time, experiment->difficulty,
                 experiment->timed_level);
    } else {
        snprintf(label, LABEL_SIZE, "%s; %s: as suits each", time, experiment->difficulty);
    }
}

/** Makes a chart. @param csv Path of its table. */
static void benchmark_chart_init(BenchmarkChart *chart, const Microbenchmark *benchmark,
                                 const Experiment *experiment, const char *csv) {
    *chart =
        (BenchmarkChart){.plot = {.kind = PLOT_POINTS, .title = experiment->title, .csv = csv}};
    write_x_label(experiment, chart->x_label);
    snprintf(chart->y_labels[0], LABEL_SIZE, "%s: one in a thousand is worse",
             experiment->error_label ? experiment->error_label : "");
    benchmark_chart_add_panel(chart, benchmark, point_error_p999, COLUMN_ERROR);
    snprintf(chart->y_labels[chart->plot.panel_count], LABEL_SIZE,
             "share of rays: leak, false hit or miss, double hit");
    benchmark_chart_add_panel(chart, benchmark, point_failures, COLUMN_FAILURES);
}

/** Lists the numbers of a row, as the table and the CSV have them. */
static void row_numbers(const MicrobenchmarkPoint *point, double numbers[ROW_NUMBERS]) {
    const double values[ROW_NUMBERS] = {point->ns.median,
                                        point->ns.low,
                                        point->ns.high,
                                        point_error_p999(point),
                                        point->result.maximum,
                                        point->result.failure_fraction,
                                        point->result.outcome_fractions[OUTCOME_DOUBLE_HIT]};
    memcpy(numbers, values, sizeof values);
}

/** @return What a table says of a row: whether it is part of a front, or tied with one that is. */
static const char *front_word(const BenchmarkChart *chart, size_t row) {
    return chart->is_pareto[row] ? gettext("yes") : chart->is_tied[row] ? gettext("tie") : "";
}

/** Prints a table. */
static void microbenchmark_print(const Microbenchmark *benchmark, const BenchmarkChart *chart,
                                 FILE *stream) {
    static const char *const columns[] = {
        N_("method"), N_("number type"), N_("ns a test"), N_("from"),        N_("to"),
        N_("error"),  N_("worst"),       N_("failures"),  N_("double hits"), N_("front")};
    Table table = table_make(COUNT_OF(columns), 2);
    table_heading(&table, columns);
    for (size_t i = 0; i < benchmark->count; i++) {
        double numbers[ROW_NUMBERS];
        row_numbers(&benchmark->points[i], numbers);
        table_cell(&table, "%s", benchmark->points[i].result.method);
        table_cell(&table, "%s", benchmark->points[i].result.type);
        for (size_t n = 0; n < ROW_NUMBERS; n++) {
            table_number(&table, numbers[n]);
        }
        table_cell(&table, "%s", front_word(chart, i));
    }
    fprintf(stream, "%s\n", gettext(chart->plot.title));
    table_print(&table, stream);
    fputc('\n', stream);
    table_deinit(&table);
}

/** Writes the CSV. @return Whether it is written. */
static bool microbenchmark_write_csv(const Microbenchmark *benchmark, const BenchmarkChart *chart,
                                     Error *error) {
    static const char *const columns[] = {"method",   "type",        "stress",     "ns",
                                          "ns_low",   "ns_high",     "error_p999", "error_max",
                                          "failures", "double_hits", "front"};
    Csv csv;
    char title[2 * LABEL_SIZE];
    snprintf(title, sizeof title, "%s; %s", chart->plot.title, chart->x_label);
    if (!csv_begin(&csv, chart->plot.csv, title, error)) {
        return false;
    }
    csv_heading(&csv, columns, COUNT_OF(columns));
    for (size_t i = 0; i < benchmark->count; i++) {
        double numbers[ROW_NUMBERS + 1];
        row_numbers(&benchmark->points[i], numbers);
        // A tie is half of a place.
        numbers[ROW_NUMBERS] = chart->is_pareto[i] ? 1 : chart->is_tied[i] ? 0.5 : 0;
        csv_text(&csv, benchmark->points[i].result.method);
        csv_text(&csv, benchmark->points[i].result.type);
        csv_number(&csv, benchmark->points[i].result.level);
        csv_numbers(&csv, numbers, COUNT_OF(numbers));
    }
    return csv_commit(&csv, error);
}

bool microbenchmark_save(const Microbenchmark *benchmark, const Experiment *experiment,
                         const LabRequest *request, bool *has_chart, Error *error) {
    char csv[PATH_MAX], svg[PATH_MAX];
    int length = snprintf(csv, sizeof csv, "%s/kernel-%s.csv", request->folder, experiment->name);
    if (length < 0 || length >= PATH_MAX) {
        return error_set(error, STATUS_FAILED, "the folder's name is too long");
    }
    snprintf(svg, sizeof svg, "%.*s.svg", length - 4, csv);
    BenchmarkChart chart;
    benchmark_chart_init(&chart, benchmark, experiment, csv);
    if (request->table_stream) {
        microbenchmark_print(benchmark, &chart, request->table_stream);
    }
    *has_chart = gnuplot_is_available();
    return microbenchmark_write_csv(benchmark, &chart, error) &&
           (!*has_chart || chart.plot.panel_count == 0 ||
            plot_draw(&chart.plot, svg, request->stop, error));
}
