/**
 * @file
 * @brief Results of an experiment as tables, as CSV, as a chart.
 */
#include "lab/charts/experiment_report.h"

#include "base/language.h"
#include "lab/charts/csv.h"
#include "lab/charts/metrics.h"
#include "lab/charts/plot.h"
#include "lab/charts/table.h"

#include <libintl.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/** Longest heading, bytes with its final zero. */
enum { HEADING_SIZE = 200 };
/** Most number types in a chart: quad is the reference. */
enum { PLOTTED_TYPES = 3 };

/** Translates a text. @return The translation. */
typedef char *TranslateFunction(const char *words);

/** Is a #TranslateFunction: English, as files are. */
static char *untranslated(const char *text) {
    return (char *)(uintptr_t)text;
}

/** @return The name of a quantity, with its unit. */
static const char *metric_label(const Metric *metric, const Experiment *experiment,
                                TranslateFunction *translate, char heading[HEADING_SIZE]) {
    const char *name = translate(metric->heading);
    if (metric->kind == METRIC_ERROR) {
        snprintf(heading, HEADING_SIZE, "%s%s%s", translate(experiment->error_label),
                 translate(N_(": ")), name);
    } else if (metric->kind == METRIC_ULPS) {
        snprintf(heading, HEADING_SIZE, translate(N_("%s, in ulps: %s")),
                 translate(experiment->error_label), name);
    } else if (metric->kind == METRIC_COST) {
        snprintf(heading, HEADING_SIZE, "%s%s%s", translate(experiment->cost_label),
                 translate(N_(": ")), name);
    } else {
        snprintf(heading, HEADING_SIZE, translate(N_("%s, %%")), name);
    }
    return heading;
}

/* --- on the terminal -----------------------------------------------------------------------------
 */

/** Adds a method in a number type to a table. */
static void add_table_row(Table *table, const Metric *metric, const Experiment *experiment,
                          const MethodResult *row) {
    table_cell(table, "%s", row->method);
    table_cell(table, "%s", row->type);
    for (size_t i = 0; i < experiment->level_count; i++) {
        double percent = metric->kind == METRIC_FRACTION ? 100 : 1;
        table_number(table, percent * metric->value(experiment, &row[i]));
    }
}

/** Prints a quantity of all methods. */
static void print_metric(const Metric *metric, const Experiment *experiment,
                         const ExperimentResults *results, FILE *stream) {
    char heading[HEADING_SIZE];
    Table table = table_make(2 + experiment->level_count, 2);
    table_cell(&table, "%s", gettext("method"));
    table_cell(&table, "%s", gettext("number type"));
    for (size_t i = 0; i < experiment->level_count; i++) {
        table_cell(&table, "%g", experiment->levels[i]);
    }
    for (size_t m = 0; m < results->method_count; m++) {
        for (size_t t = 0; t < results->type_count; t++) {
            const MethodResult *row = experiment_results_at(results, m, t, 0);
            if (row->sample_count > 0) {
                add_table_row(&table, metric, experiment, row);
            }
        }
    }
    fprintf(stream, gettext("\n  %s; against %s\n"),
            metric_label(metric, experiment, gettext, heading), gettext(experiment->difficulty));
    table_print(&table, stream);
    table_deinit(&table);
}

/** @return Whether a quantity is measured, and is 0 somewhere. */
static bool metric_is_measured(const Metric *metric, const Experiment *experiment,
                               const ExperimentResults *results) {
    size_t count = results->method_count * results->type_count * results->level_count;
    for (size_t i = 0; i < count; i++) {
        if (results->rows[i].sample_count > 0 &&
            metric->value(experiment, &results->rows[i]) == 0) {
            return true;
        }
    }
    return false;
}

void experiment_report_print(const Experiment *experiment, const ExperimentResults *results,
                             FILE *stream) {
    char heading[HEADING_SIZE];
    fprintf(stream, "%s: %s\n", experiment->name, gettext(experiment->title));
    for (size_t i = 0; i < METRIC_COUNT; i++) {
        const Metric *metric = metric_at(i);
        bool is_shown_in_ulps = metric->kind == METRIC_ERROR && experiment->is_relative;
        if (is_shown_in_ulps) {
            continue;
        }
        if (metric_is_nonzero(metric, experiment, results)) {
            print_metric(metric, experiment, results, stream);
        } else if (metric_is_measured(metric, experiment, results)) {
            fprintf(stream, gettext("\n  %s: none\n"),
                    metric_label(metric, experiment, gettext, heading));
        }
    }
    fputc('\n', stream);
}

/* --- as comma-separated values -------------------------------------------------------------------
 */

/** Writes the names of the columns. */
static void write_heading(Csv *csv) {
    csv_text(csv, "method");
    csv_text(csv, "type");
    csv_text(csv, "stress");
    csv_text(csv, "cases");
    for (size_t i = 0; i < METRIC_COUNT; i++) {
        csv_text(csv, metric_at(i)->column);
    }
    csv_end_row(csv);
}

/** Writes a result. */
static void write_row(Csv *csv, const Experiment *experiment, const MethodResult *result) {
    csv_text(csv, result->method);
    csv_text(csv, result->type);
    csv_number(csv, result->level);
    csv_number(csv, (double)result->sample_count);
    for (size_t i = 0; i < METRIC_COUNT; i++) {
        csv_number(csv, metric_at(i)->value(experiment, result));
    }
    csv_end_row(csv);
}

bool experiment_report_write_csv(const Experiment *experiment, const ExperimentResults *results,
                                 const char *path, Error *error) {
    Csv csv;
    char title[2 * HEADING_SIZE];
    snprintf(title, sizeof title, "%s; stress: %s; error: %s", experiment->title,
             experiment->difficulty, experiment->error_label ? experiment->error_label : "none");
    if (!csv_begin(&csv, path, title, error)) {
        return false;
    }
    write_heading(&csv);
    size_t count = results->method_count * results->type_count * results->level_count;
    for (size_t i = 0; i < count; i++) {
        if (results->rows[i].sample_count > 0) {
            write_row(&csv, experiment, &results->rows[i]);
        }
    }
    return csv_commit(&csv, error);
}

/* --- as a chart ----------------------------------------------------------------------------------
 */

/** A chart and its data. */
typedef struct ReportPlot {
    const Experiment *experiment;     /**< The experiment. */
    const ExperimentResults *results; /**< The results. */
    double *y_values;                 /**< The y of all lines; owned. */
    size_t y_count;                   /**< Number of #y_values. */
    Plot plot;                        /**< The chart. */
} ReportPlot;

/** Adds a line to a panel. @param method Index of the method. */
static void panel_add_method_series(ReportPlot *chart, PlotPanel *panel, size_t metric,
                                    size_t method, size_t type) {
    const Experiment *experiment = chart->experiment;
    const MethodResult *row = experiment_results_at(chart->results, method, type, 0);
    double *y = chart->y_values + chart->y_count;
    if (row->sample_count == 0 || panel->series_count == PLOT_SERIES_MAXIMUM) {
        return;
    }
    for (size_t i = 0; i < experiment->level_count; i++) {
        y[i] = metric_at(metric)->value(experiment, &row[i]);
    }
    chart->y_count += experiment->level_count;
    /** The last style is black: the tracer's own. */
    const int own_style = 7;
    panel->series[panel->series_count++] =
        (PlotSeries){.label = row->label,
                     .keys = {{1, row->method}, {2, row->type}},
                     .y_column = METRIC_FIRST_COLUMN + (int)metric,
                     .x = experiment->levels,
                     .y = y,
                     .count = experiment->level_count,
                     .style = strcmp(row->method, TRACER_METHOD) == 0 ? own_style : (int)method};
}

/** Adds a row of panels, one per number type. @param names Receives its name; must live as long as
 * the chart. */
static void plot_add_metric_row(ReportPlot *chart, size_t metric, char names[HEADING_SIZE]) {
    const Experiment *experiment = chart->experiment;
    Plot *plot = &chart->plot;
    PlotPanel *row = &plot->panels[plot->panel_count];
    const double *levels = experiment->levels;
    const Metric *kind = metric_at(metric);
    if (kind->kind == METRIC_FRACTION) {
        snprintf(names, HEADING_SIZE, "%s, share of rays", kind->heading);
    } else {
        metric_label(kind, experiment, untranslated, names);
    }
    for (size_t t = 0; t < plot->columns; t++, plot->panel_count++) {
        PlotPanel *panel = &plot->panels[plot->panel_count];
        *panel = (PlotPanel){.title = number_types()[t]->name,
                             .x_label = experiment->difficulty,
                             .y_label = names,
                             .x_columns = {3},
                             .is_x_reversed = levels[0] > levels[experiment->level_count - 1]};
        for (size_t m = 0; m < chart->results->method_count; m++) {
            panel_add_method_series(chart, panel, metric, m, t);
        }
    }
    plot_set_common_y_range(row, plot->columns);
}

bool experiment_report_draw(const Experiment *experiment, const ExperimentResults *results,
                            const ReportPaths *files, const atomic_bool *stop, Error *error) {
    char names[METRIC_COUNT][HEADING_SIZE];
    size_t types = results->type_count - 1;
    ReportPlot chart = {.experiment = experiment, .results = results};
    chart.plot = (Plot){.title = experiment->title,
                        .csv = files->csv,
                        .columns = types < PLOTTED_TYPES ? types : PLOTTED_TYPES};
    chart.y_values =
        calloc(METRIC_COUNT * results->method_count * results->type_count * results->level_count,
               sizeof *chart.y_values);
    if (!chart.y_values) {
        return error_set(error, STATUS_FAILED, "no memory for a chart");
    }
    for (size_t i = 0; i < METRIC_COUNT; i++) {
        const Metric *metric = metric_at(i);
        bool has_room = chart.plot.panel_count + chart.plot.columns <= PLOT_PANELS_MAXIMUM;
        if (metric->is_plotted && has_room && metric_is_nonzero(metric, experiment, results)) {
            plot_add_metric_row(&chart, i, names[i]);
        }
    }
    bool is_drawn = plot_draw(&chart.plot, files->svg, stop, error);
    free(chart.y_values);
    return is_drawn;
}
