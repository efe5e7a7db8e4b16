/**
 * @file
 * @brief What was found of methods' speed and accuracy, as a table, as CSV, as a chart.
 */
#include "lab/kernel.h"

#include "dioptre/language.h"
#include "lab/csv.h"
#include "lab/gnuplot.h"
#include "lab/scatter.h"
#include "lab/table.h"

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

/** @return A method's error; NaN where there is none. @param point The method. */
static double error_of(const KernelPoint *point) {
    return point->finding.p999;
}

/** @return A method's failures; NaN where there are none. @param point The method. */
static double failures_of(const KernelPoint *point) {
    return point->failures;
}

/** What a chart is drawn of. */
typedef struct Drawn {
    Scatter scatter;                                            /**< It. */
    char titles[SCATTER_PANELS_MAXIMUM][TITLE_SIZE];            /**< Of its panels. */
    char headings[SCATTER_PANELS_MAXIMUM][HEADING_SIZE];        /**< Of their y. */
    char x_label[HEADING_SIZE];                                 /**< Of x. */
    bool fronts[SCATTER_PANELS_MAXIMUM][KERNEL_POINTS_MAXIMUM]; /**< Whether each is of a front. */
} Drawn;

/** @return The place of a number type. @param name Its name. */
static int kind_of(const char *name) {
    int place = 0;
    while (strcmp(number_types()[place]->name, name) != 0) {
        place++;
    }
    return place;
}

/** @return How many number types are drawn: quad is measured against its equal. */
static size_t drawn_types(void) {
    size_t count = 0;
    while (number_types()[count + 1]) {
        count++;
    }
    return count;
}

/** Puts the front of a panel into words. @param panel The panel. @param kinds What kinds of points
 *  are called. @param[out] title The words. */
static void front_say(const ScatterPanel *panel, const char *const *kinds, char title[TITLE_SIZE]) {
    const char *comma = "front: ";
    title[0] = '\0';
    for (size_t i = 0; i < panel->count; i++) {
        const ScatterPoint *point = &panel->points[i];
        size_t length = strlen(title);
        if (point->is_front) {
            snprintf(title + length, TITLE_SIZE - length, "%s%s %s", comma, point->label,
                     kinds[point->kind]);
            comma = ", ";
        }
    }
}

/** Adds a panel, where there is anything to be seen. @param[in,out] drawn The chart; the panel's
 *  heading is there. @param kernel What was found. @param of What y is. @param column Of y. */
static void panel_add(Drawn *drawn, const Kernel *kernel, double (*of)(const KernelPoint *point),
                      int column) {
    Scatter *scatter = &drawn->scatter;
    size_t place = scatter->count, rows[SCATTER_POINTS_MAXIMUM];
    ScatterPanel *panel = &scatter->panels[place];
    double sum = 0;
    *panel = (ScatterPanel){.title = drawn->titles[place],
                            .y_label = drawn->headings[place],
                            .y_column = column,
                            .is_share = column == COLUMN_FAILURES};
    for (size_t i = 0; i < kernel->count; i++) {
        const KernelPoint *point = &kernel->points[i];
        int kind = kind_of(point->finding.type);
        double y = of(point);
        if (kind < (int)scatter->kind_count && !isnan(y)) {
            rows[panel->count] = i;
            panel->points[panel->count++] =
                (ScatterPoint){.label = point->finding.label, .x = point->ns, .y = y, .kind = kind};
            sum += y;
        }
    }
    if (sum > 0) {
        scatter_find_front(panel);
        front_say(panel, scatter->kinds, drawn->titles[place]);
        for (size_t i = 0; i < panel->count; i++) {
            drawn->fronts[place][rows[i]] = panel->points[i].is_front;
        }
        scatter->count++;
    }
}

/** Says what time is measured of, and at which stress. @param experiment The experiment.
 *  @param[out] text The words. */
static void x_say(const Experiment *experiment, char text[HEADING_SIZE]) {
    static const char *const time = "nanoseconds a test, one thread";
    if (experiment->timed > 0) {
        snprintf(text, HEADING_SIZE, "%s; %s: %g", time, experiment->stress, experiment->timed);
    } else {
        snprintf(text, HEADING_SIZE, "%s; %s: as suits each", time, experiment->stress);
    }
}

/** Lays a chart out. @param[out] drawn The chart. @param kernel What was found. @param experiment
 *  Of which. @param csv Its table. */
static void lay_out(Drawn *drawn, const Kernel *kernel, const Experiment *experiment,
                    const char *csv) {
    *drawn = (Drawn){.scatter = {.title = experiment->title,
                                 .csv = csv,
                                 .x_label = drawn->x_label,
                                 .x_columns = {COLUMN_NS, COLUMN_NS + 1, COLUMN_NS + 2},
                                 .kind_column = COLUMN_TYPE,
                                 .kind_count = drawn_types()}};
    x_say(experiment, drawn->x_label);
    for (size_t i = 0; i < drawn->scatter.kind_count; i++) {
        drawn->scatter.kinds[i] = number_types()[i]->name;
    }
    snprintf(drawn->headings[0], HEADING_SIZE, "%s: one in a thousand is worse",
             experiment->error ? experiment->error : "");
    panel_add(drawn, kernel, error_of, COLUMN_ERROR);
    snprintf(drawn->headings[drawn->scatter.count], HEADING_SIZE,
             "share of rays: false, leaking or wrong");
    panel_add(drawn, kernel, failures_of, COLUMN_FAILURES);
}

/** @return Whether a method is of some front. @param drawn The chart. @param i Which method. */
static bool is_front(const Drawn *drawn, size_t i) {
    bool is_front = false;
    for (size_t panel = 0; panel < drawn->scatter.count; panel++) {
        is_front = is_front || drawn->fronts[panel][i];
    }
    return is_front;
}

/** Prints a table. @param kernel What was found. @param drawn With its fronts. @param stream Where
 *  to. */
static void kernel_print(const Kernel *kernel, const Drawn *drawn, FILE *stream) {
    static const char *const heads[] = {
        N_("method"), N_("number type"), N_("ns a test"), N_("from"),        N_("to"),
        N_("error"),  N_("worst"),       N_("failures"),  N_("double hits"), N_("front")};
    Table table = table_of(sizeof heads / sizeof *heads, 2);
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        table_cell(&table, "%s", gettext(heads[i]));
    }
    for (size_t i = 0; i < kernel->count; i++) {
        const KernelPoint *point = &kernel->points[i];
        table_cell(&table, "%s", point->finding.method);
        table_cell(&table, "%s", point->finding.type);
        table_number(&table, point->ns);
        table_number(&table, point->ns_low);
        table_number(&table, point->ns_high);
        table_number(&table, error_of(point));
        table_number(&table, point->finding.maximum);
        table_number(&table, point->failures);
        table_number(&table, point->finding.shares[OUTCOME_DOUBLE_HIT]);
        table_cell(&table, "%s", is_front(drawn, i) ? gettext("yes") : "");
    }
    fprintf(stream, "%s\n", gettext(drawn->scatter.title));
    table_print(&table, stream);
    fputc('\n', stream);
    table_release(&table);
}

/** Writes a row. @param[in,out] csv The table. @param point A method. @param front Whether it is of
 *  a front. */
static void row_write(Csv *csv, const KernelPoint *point, bool front) {
    csv_word(csv, point->finding.method);
    csv_word(csv, point->finding.type);
    const double numbers[] = {point->finding.level,
                              point->ns,
                              point->ns_low,
                              point->ns_high,
                              error_of(point),
                              point->finding.maximum,
                              point->failures,
                              point->finding.shares[OUTCOME_DOUBLE_HIT],
                              front};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        csv_number(csv, numbers[i]);
    }
    csv_end_row(csv);
}

/** Writes the table. @param kernel What was found. @param drawn With its fronts, its title and its
 *  file. @param[out] error What is wrong. @return Whether it is there. */
static bool kernel_write(const Kernel *kernel, const Drawn *drawn, Error *error) {
    static const char *const heads[] = {"method",   "type",        "stress",     "ns",
                                        "ns_low",   "ns_high",     "error_p999", "error_max",
                                        "failures", "double_hits", "front"};
    Csv csv;
    char title[2 * HEADING_SIZE];
    snprintf(title, sizeof title, "%s; %s", drawn->scatter.title, drawn->x_label);
    if (!csv_begin(&csv, drawn->scatter.csv, title, error)) {
        return false;
    }
    for (size_t i = 0; i < sizeof heads / sizeof *heads; i++) {
        csv_word(&csv, heads[i]);
    }
    csv_end_row(&csv);
    for (size_t i = 0; i < kernel->count; i++) {
        row_write(&csv, &kernel->points[i], is_front(drawn, i));
    }
    return csv_commit(&csv, error);
}

bool kernel_keep(const Kernel *kernel, const Experiment *experiment, const LabRequest *request,
                 bool *has_chart, Error *error) {
    char csv[PATH_MAX], svg[PATH_MAX];
    int length = snprintf(csv, sizeof csv, "%s/kernel-%s.csv", request->folder, experiment->name);
    if (length < 0 || length >= PATH_MAX) {
        return error_set(error, STATUS_FAILED, "the folder's name is too long");
    }
    snprintf(svg, sizeof svg, "%.*s.svg", length - 4, csv);
    Drawn drawn;
    lay_out(&drawn, kernel, experiment, csv);
    if (request->table) {
        kernel_print(kernel, &drawn, request->table);
    }
    *has_chart = gnuplot_is_there();
    return kernel_write(kernel, &drawn, error) &&
           (!*has_chart || drawn.scatter.count == 0 ||
            scatter_draw(&drawn.scatter, svg, request->stop, error));
}
