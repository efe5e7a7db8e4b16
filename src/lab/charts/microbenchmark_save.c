/**
 * @file
 * @brief What was found of methods' speed and accuracy, as a table, as CSV, as a chart.
 */
#include "lab/microbenchmark.h"

#include "base/language.h"
#include "lab/charts/csv.h"
#include "lab/charts/gnuplot.h"
#include "lab/charts/scatter.h"
#include "lab/charts/table.h"

#include <libintl.h>
#include <limits.h>
#include <math.h>
#include <string.h>

/** Columns of the CSV that charts are drawn from. */
enum { COLUMN_TYPE = 2, COLUMN_NS = 4, COLUMN_ERROR = 7, COLUMN_FAILURES = 9 };
/** Longest title of a panel, bytes with its final zero. */
enum { TITLE_SIZE = 400 };
/** Longest heading, bytes with its final zero. */
enum { HEADING_SIZE = 160 };

/** @return A method's error; NaN where there is none. */
static double point_error_p999(const MicrobenchmarkPoint *point) {
    return point->result.p999;
}

/** @return A method's failures; NaN where there are none. */
static double point_failures(const MicrobenchmarkPoint *point) {
    return point->failure_fraction;
}

/** What a chart is drawn of. */
typedef struct BenchmarkChart {
    Scatter scatter;                                     /**< It. */
    char titles[SCATTER_PANELS_MAXIMUM][TITLE_SIZE];     /**< Of its panels. */
    char y_labels[SCATTER_PANELS_MAXIMUM][HEADING_SIZE]; /**< Of their y. */
    char x_label[HEADING_SIZE];                          /**< Of x. */
    bool is_pareto[SCATTER_PANELS_MAXIMUM]
                  [MICROBENCHMARK_POINTS_MAXIMUM]; /**< Whether each is of a front. */
} BenchmarkChart;

/** @return The place of a number type. */
static int type_index(const char *name) {
    int index = 0;
    while (strcmp(number_types()[index]->name, name) != 0) {
        index++;
    }
    return index;
}

/** @return How many number types are drawn: quad is measured against its equal. */
static size_t plotted_type_count(void) {
    size_t count = 0;
    while (number_types()[count + 1]) {
        count++;
    }
    return count;
}

/** Puts the front of a panel into words. @param kinds What kinds of points are called. */
static void pareto_caption(const ScatterPanel *panel, const char *const *kinds,
                           char title[TITLE_SIZE]) {
    const char *comma = "front: ";
    title[0] = '\0';
    for (size_t i = 0; i < panel->point_count; i++) {
        const ScatterPoint *point = &panel->points[i];
        size_t length = strlen(title);
        if (point->is_pareto) {
            snprintf(title + length, TITLE_SIZE - length, "%s%s %s", comma, point->label,
                     kinds[point->kind]);
            comma = ", ";
        }
    }
}

/** Adds a panel, where there is anything to be seen. @param[in,out] layout The chart; the panel's
 *  heading is there. */
static void benchmark_chart_add_panel(BenchmarkChart *layout, const Microbenchmark *benchmark,
                                      double (*of)(const MicrobenchmarkPoint *point), int column) {
    Scatter *scatter = &layout->scatter;
    size_t index = scatter->panel_count, rows[SCATTER_POINTS_MAXIMUM];
    ScatterPanel *panel = &scatter->panels[index];
    double sum = 0;
    *panel = (ScatterPanel){.title = layout->titles[index],
                            .y_label = layout->y_labels[index],
                            .y_column = column,
                            .is_fraction = column == COLUMN_FAILURES};
    for (size_t i = 0; i < benchmark->count; i++) {
        const MicrobenchmarkPoint *point = &benchmark->points[i];
        int kind = type_index(point->result.type);
        double y = of(point);
        if (kind < (int)scatter->kind_count && !isnan(y)) {
            rows[panel->point_count] = i;
            panel->points[panel->point_count++] =
                (ScatterPoint){.label = point->result.label, .x = point->ns, .y = y, .kind = kind};
            sum += y;
        }
    }
    if (sum > 0) {
        scatter_find_pareto_front(panel);
        pareto_caption(panel, scatter->kinds, layout->titles[index]);
        for (size_t i = 0; i < panel->point_count; i++) {
            layout->is_pareto[index][rows[i]] = panel->points[i].is_pareto;
        }
        scatter->panel_count++;
    }
}

/** Says what time is measured of, and at which stress. */
static void describe_x_axis(const Experiment *experiment, char text[HEADING_SIZE]) {
    static const char *const time = "nanoseconds a test, one thread";
    if (experiment->timed_level > 0) {
        snprintf(text, HEADING_SIZE, "%s; %s: %g", time, experiment->difficulty,
                 experiment->timed_level);
    } else {
        snprintf(text, HEADING_SIZE, "%s; %s: as suits each", time, experiment->difficulty);
    }
}

/** Lays a chart out. */
static void benchmark_chart_init(BenchmarkChart *layout, const Microbenchmark *benchmark,
                                 const Experiment *experiment, const char *csv) {
    *layout = (BenchmarkChart){.scatter = {.title = experiment->title,
                                           .csv = csv,
                                           .x_label = layout->x_label,
                                           .x_columns = {COLUMN_NS, COLUMN_NS + 1, COLUMN_NS + 2},
                                           .kind_column = COLUMN_TYPE,
                                           .kind_count = plotted_type_count()}};
    describe_x_axis(experiment, layout->x_label);
    for (size_t i = 0; i < layout->scatter.kind_count; i++) {
        layout->scatter.kinds[i] = number_types()[i]->name;
    }
    snprintf(layout->y_labels[0], HEADING_SIZE, "%s: one in a thousand is worse",
             experiment->error_label ? experiment->error_label : "");
    benchmark_chart_add_panel(layout, benchmark, point_error_p999, COLUMN_ERROR);
    snprintf(layout->y_labels[layout->scatter.panel_count], HEADING_SIZE,
             "share of rays: false, leaking or wrong");
    benchmark_chart_add_panel(layout, benchmark, point_failures, COLUMN_FAILURES);
}

/** @return Whether a method is of some front. */
static bool is_on_pareto_front(const BenchmarkChart *layout, size_t i) {
    bool is_on_pareto_front = false;
    for (size_t panel = 0; panel < layout->scatter.panel_count; panel++) {
        is_on_pareto_front = is_on_pareto_front || layout->is_pareto[panel][i];
    }
    return is_on_pareto_front;
}

/** Prints a table. */
static void microbenchmark_print(const Microbenchmark *benchmark, const BenchmarkChart *layout,
                                 FILE *stream) {
    static const char *const heads[] = {
        N_("method"), N_("number type"), N_("ns a test"), N_("from"),        N_("to"),
        N_("error"),  N_("worst"),       N_("failures"),  N_("double hits"), N_("front")};
    Table table = table_make(sizeof heads / sizeof *heads, 2);
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        table_cell(&table, "%s", gettext(heads[i]));
    }
    for (size_t i = 0; i < benchmark->count; i++) {
        const MicrobenchmarkPoint *point = &benchmark->points[i];
        table_cell(&table, "%s", point->result.method);
        table_cell(&table, "%s", point->result.type);
        table_number(&table, point->ns);
        table_number(&table, point->ns_low);
        table_number(&table, point->ns_high);
        table_number(&table, point_error_p999(point));
        table_number(&table, point->result.maximum);
        table_number(&table, point->failure_fraction);
        table_number(&table, point->result.outcome_fractions[OUTCOME_DOUBLE_HIT]);
        table_cell(&table, "%s", is_on_pareto_front(layout, i) ? gettext("yes") : "");
    }
    fprintf(stream, "%s\n", gettext(layout->scatter.title));
    table_print(&table, stream);
    fputc('\n', stream);
    table_deinit(&table);
}

/** Writes a row. @param is_pareto Whether it is of a front. */
static void write_csv_row(Csv *csv, const MicrobenchmarkPoint *point, bool is_pareto) {
    csv_text(csv, point->result.method);
    csv_text(csv, point->result.type);
    const double numbers[] = {point->result.level,
                              point->ns,
                              point->ns_low,
                              point->ns_high,
                              point_error_p999(point),
                              point->result.maximum,
                              point->failure_fraction,
                              point->result.outcome_fractions[OUTCOME_DOUBLE_HIT],
                              is_pareto};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        csv_number(csv, numbers[i]);
    }
    csv_end_row(csv);
}

/**
 * Writes the table.
 * @param layout  With its fronts, its title and its file.
 * @return Whether it is there.
 */
static bool microbenchmark_write_csv(const Microbenchmark *benchmark, const BenchmarkChart *layout,
                                     Error *error) {
    static const char *const heads[] = {"method",   "type",        "stress",     "ns",
                                        "ns_low",   "ns_high",     "error_p999", "error_max",
                                        "failures", "double_hits", "front"};
    Csv csv;
    char title[2 * HEADING_SIZE];
    snprintf(title, sizeof title, "%s; %s", layout->scatter.title, layout->x_label);
    if (!csv_begin(&csv, layout->scatter.csv, title, error)) {
        return false;
    }
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        csv_text(&csv, heads[i]);
    }
    csv_end_row(&csv);
    for (size_t i = 0; i < benchmark->count; i++) {
        write_csv_row(&csv, &benchmark->points[i], is_on_pareto_front(layout, i));
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
    BenchmarkChart layout;
    benchmark_chart_init(&layout, benchmark, experiment, csv);
    if (request->table_stream) {
        microbenchmark_print(benchmark, &layout, request->table_stream);
    }
    *has_chart = gnuplot_is_available();
    return microbenchmark_write_csv(benchmark, &layout, error) &&
           (!*has_chart || layout.scatter.panel_count == 0 ||
            scatter_draw(&layout.scatter, svg, request->stop, error));
}
