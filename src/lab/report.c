/**
 * @file
 * @brief What an experiment has found, for people and for programs.
 */
#include "lab/report.h"

#include "dioptre/language.h"
#include "lab/csv.h"
#include "lab/figures.h"
#include "lab/plot.h"
#include "lab/table.h"

#include <libintl.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/** Longest heading, bytes with its final zero. */
enum { HEADING_SIZE = 200 };
/** Most number types that a chart shows side by side: quad is measured against itself. */
enum { CHARTED_TYPES = 3 };

/** Says words in a language. @param words They, in English. @return They. */
typedef char *Speaker(const char *words);

/** Is a #Speaker: English, as files are. @param words They. @return They. */
static char *in_english(const char *words) {
    return (char *)(uintptr_t)words;
}

/** @return What a figure is, with its unit. @param figure The figure. @param experiment Of which.
 *  @param say In which language. @param[out] heading Room for it. */
static const char *name_figure(const Figure *figure, const Experiment *experiment, Speaker *say,
                               char heading[HEADING_SIZE]) {
    const char *name = say(figure->heading);
    if (figure->kind == FIGURE_ERROR) {
        snprintf(heading, HEADING_SIZE, say(N_("%s: %s")), say(experiment->error), name);
    } else if (figure->kind == FIGURE_ULPS) {
        snprintf(heading, HEADING_SIZE, say(N_("%s, in ulps: %s")), say(experiment->error), name);
    } else if (figure->kind == FIGURE_WORK) {
        snprintf(heading, HEADING_SIZE, say(N_("%s: %s")), say(experiment->work), name);
    } else {
        snprintf(heading, HEADING_SIZE, say(N_("%s, %%")), name);
    }
    return heading;
}

/* --- on the terminal -----------------------------------------------------------------------------
 */

/** Adds a method in a number type to a table. @param[in,out] table The table. @param figure The
 *  figure. @param experiment Of which. @param row Its first finding. */
static void add_row(Table *table, const Figure *figure, const Experiment *experiment,
                    const Finding *row) {
    table_cell(table, "%s", row->method);
    table_cell(table, "%s", row->type);
    for (size_t i = 0; i < experiment->level_count; i++) {
        double percent = figure->kind == FIGURE_SHARE ? 100 : 1;
        table_number(table, percent * figure->of(experiment, &row[i]));
    }
}

/** Prints a figure of all methods. @param figure The figure. @param experiment Of which.
 *  @param findings What was found. @param stream Where to. */
static void print_figure(const Figure *figure, const Experiment *experiment,
                         const Findings *findings, FILE *stream) {
    char heading[HEADING_SIZE];
    Table table = table_of(2 + experiment->level_count, 2);
    table_cell(&table, "%s", gettext("method"));
    table_cell(&table, "%s", gettext("number type"));
    for (size_t i = 0; i < experiment->level_count; i++) {
        table_cell(&table, "%g", experiment->levels[i]);
    }
    for (size_t m = 0; m < findings->method_count; m++) {
        for (size_t t = 0; t < findings->type_count; t++) {
            const Finding *row = findings_at(findings, m, t, 0);
            if (row->cases > 0) {
                add_row(&table, figure, experiment, row);
            }
        }
    }
    fprintf(stream, gettext("\n  %s; against %s\n"),
            name_figure(figure, experiment, gettext, heading), gettext(experiment->stress));
    table_print(&table, stream);
    table_release(&table);
}

/** @return Whether a figure could have been anything but 0. @param figure The figure.
 *  @param experiment Of which. @param findings What was found. */
static bool is_counted(const Figure *figure, const Experiment *experiment,
                       const Findings *findings) {
    size_t count = findings->method_count * findings->type_count * findings->level_count;
    for (size_t i = 0; i < count; i++) {
        if (findings->rows[i].cases > 0 && figure->of(experiment, &findings->rows[i]) == 0) {
            return true;
        }
    }
    return false;
}

void report_print(const Experiment *experiment, const Findings *findings, FILE *stream) {
    char heading[HEADING_SIZE];
    fprintf(stream, "%s: %s\n", experiment->name, gettext(experiment->title));
    for (size_t i = 0; i < FIGURE_COUNT; i++) {
        const Figure *figure = figure_at(i);
        bool is_said_in_ulps = figure->kind == FIGURE_ERROR && experiment->is_relative;
        if (is_said_in_ulps) {
            continue;
        }
        if (figure_is_found(figure, experiment, findings)) {
            print_figure(figure, experiment, findings, stream);
        } else if (is_counted(figure, experiment, findings)) {
            fprintf(stream, gettext("\n  %s: none\n"),
                    name_figure(figure, experiment, gettext, heading));
        }
    }
    fputc('\n', stream);
}

/* --- as comma-separated values -------------------------------------------------------------------
 */

/** Writes the names of the columns. @param[in,out] csv The table. */
static void write_heading(Csv *csv) {
    csv_word(csv, "method");
    csv_word(csv, "type");
    csv_word(csv, "stress");
    csv_word(csv, "cases");
    for (size_t i = 0; i < FIGURE_COUNT; i++) {
        csv_word(csv, figure_at(i)->column);
    }
    csv_end_row(csv);
}

/** Writes a finding. @param[in,out] csv The table. @param experiment Of which. @param finding It.
 */
static void write_row(Csv *csv, const Experiment *experiment, const Finding *finding) {
    csv_word(csv, finding->method);
    csv_word(csv, finding->type);
    csv_number(csv, finding->level);
    csv_number(csv, (double)finding->cases);
    for (size_t i = 0; i < FIGURE_COUNT; i++) {
        csv_number(csv, figure_at(i)->of(experiment, finding));
    }
    csv_end_row(csv);
}

bool report_write(const Experiment *experiment, const Findings *findings, const char *path,
                  Error *error) {
    Csv csv;
    char title[2 * HEADING_SIZE];
    snprintf(title, sizeof title, "%s; stress: %s; error: %s", experiment->title,
             experiment->stress, experiment->error ? experiment->error : "none");
    if (!csv_begin(&csv, path, title, error)) {
        return false;
    }
    write_heading(&csv);
    size_t count = findings->method_count * findings->type_count * findings->level_count;
    for (size_t i = 0; i < count; i++) {
        if (findings->rows[i].cases > 0) {
            write_row(&csv, experiment, &findings->rows[i]);
        }
    }
    return csv_commit(&csv, error);
}

/* --- as a chart ----------------------------------------------------------------------------------
 */

/** A chart with what it is drawn from. */
typedef struct Chart {
    const Experiment *experiment; /**< The experiment. */
    const Findings *findings;     /**< What was found. */
    double *numbers;              /**< The y of all lines; owned. */
    size_t used;                  /**< How many. */
    Plot plot;                    /**< The chart. */
} Chart;

/** Adds a line to a panel. @param[in,out] chart The chart. @param[in,out] panel The panel.
 *  @param figure Which figure. @param method Place of the method. @param type Of the type. */
static void add_line(Chart *chart, PlotPanel *panel, size_t figure, size_t method, size_t type) {
    const Experiment *experiment = chart->experiment;
    const Finding *row = findings_at(chart->findings, method, type, 0);
    double *y = chart->numbers + chart->used;
    if (row->cases == 0 || panel->count == PLOT_LINES_MAXIMUM) {
        return;
    }
    for (size_t i = 0; i < experiment->level_count; i++) {
        y[i] = figure_at(figure)->of(experiment, &row[i]);
    }
    chart->used += experiment->level_count;
    /** The last style is black: the tracer's own. */
    const int own_style = 7;
    panel->lines[panel->count++] =
        (PlotLine){.label = row->label,
                   .keys = {row->method, row->type},
                   .column = FIGURE_FIRST_COLUMN + (int)figure,
                   .x = experiment->levels,
                   .y = y,
                   .count = experiment->level_count,
                   .style = strcmp(row->method, OWN_METHOD) == 0 ? own_style : (int)method};
}

/** Adds a row of panels, one for each number type. @param[in,out] chart The chart.
 *  @param figure Which figure. @param names Where it is named, for as long as the chart lives. */
static void add_panels(Chart *chart, size_t figure, char names[HEADING_SIZE]) {
    const Experiment *experiment = chart->experiment;
    Plot *plot = &chart->plot;
    PlotPanel *row = &plot->panels[plot->count];
    const double *levels = experiment->levels;
    const Figure *kind = figure_at(figure);
    if (kind->kind == FIGURE_SHARE) {
        snprintf(names, HEADING_SIZE, "%s, share of rays", kind->heading);
    } else {
        name_figure(kind, experiment, in_english, names);
    }
    for (size_t t = 0; t < plot->columns; t++, plot->count++) {
        PlotPanel *panel = &plot->panels[plot->count];
        *panel = (PlotPanel){.title = number_types()[t]->name,
                             .x_label = experiment->stress,
                             .y_label = names,
                             .x_column = 3,
                             .is_falling = levels[0] > levels[experiment->level_count - 1]};
        for (size_t m = 0; m < chart->findings->method_count; m++) {
            add_line(chart, panel, figure, m, t);
        }
    }
    plot_share_range(row, plot->columns);
}

bool report_draw(const Experiment *experiment, const Findings *findings, const ChartFiles *files,
                 const atomic_bool *stop, Error *error) {
    char names[FIGURE_COUNT][HEADING_SIZE];
    size_t types = findings->type_count - 1;
    Chart chart = {.experiment = experiment, .findings = findings};
    chart.plot = (Plot){.title = experiment->title,
                        .csv = files->csv,
                        .columns = types < CHARTED_TYPES ? types : CHARTED_TYPES};
    chart.numbers =
        calloc(FIGURE_COUNT * findings->method_count * findings->type_count * findings->level_count,
               sizeof *chart.numbers);
    if (!chart.numbers) {
        return error_set(error, STATUS_FAILED, "no memory for a chart");
    }
    for (size_t i = 0; i < FIGURE_COUNT; i++) {
        const Figure *figure = figure_at(i);
        bool has_room = chart.plot.count + chart.plot.columns <= PLOT_PANELS_MAXIMUM;
        if (figure->is_charted && has_room && figure_is_found(figure, experiment, findings)) {
            add_panels(&chart, i, names[i]);
        }
    }
    bool is_drawn = plot_draw(&chart.plot, files->svg, stop, error);
    free(chart.numbers);
    return is_drawn;
}
