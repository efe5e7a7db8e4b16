/**
 * @file
 * @brief `dioptre lab`: accuracy tests of methods.
 */
#include "dioptre/lab.h"
#include "base/language.h"
#include "base/suggest.h"
#include "cli/commands.h"

#include <stdio.h>
#include <string.h>

/** The package of the program that draws charts. */
#define CHART_PACKAGE "gnuplot-nox"

bool command_find_test(const char *name, size_t *index, Error *error) {
    char names[ERROR_MESSAGE_SIZE] = "", hint[SUGGEST_HINT_SIZE];
    Suggestion suggestion = {.word = name};
    for (size_t i = 0; i < lab_test_count(); i++) {
        const char *test = lab_test_at(i).name;
        if (strcmp(test, name) == 0) {
            *index = i;
            return true;
        }
        suggest_try(&suggestion, test);
        size_t length = strlen(names);
        snprintf(names + length, sizeof names - length, "%s%s", i ? ", " : "", test);
    }
    return error_set(error, STATUS_USAGE, "there is no test '%s'%s; there are %s", name,
                     suggest_hint(&suggestion, hint), names);
}

int command_threads(const Options *options) {
    return options->threads ? options->threads : render_cpu_count();
}

/** Says so if charts are missing. @param count Number of these. @return Whether none is. */
static bool check_charts(size_t count, Error *error) {
    return count == 0 || error_set(error, STATUS_FAILED,
                                   "the CSV files are written; for the charts gnuplot is missing: "
                                   "sudo apt-get install %s",
                                   CHART_PACKAGE);
}

bool command_run_each(const Options *options, ProgressItem item, size_t count, ChartedRun *run,
                      const void *context, Error *error) {
    size_t without_chart = 0;
    bool is_good = true;
    Progress *progress = progress_begin(options, item, (int)count);
    progress_start(progress);
    for (size_t i = 0; i < count && is_good; i++) {
        bool has_chart = false;
        is_good = run(context, i, &has_chart, error);
        if (is_good) {
            progress_done(progress);
        }
        without_chart += !has_chart;
    }
    progress_end(progress);
    return is_good && check_charts(without_chart, error);
}

/** The tests of a command line. */
typedef struct TestRun {
    const Options *options;    /**< The command line; without names, all tests are meant. */
    const LabRequest *request; /**< What is asked of them. */
} TestRun;

/** Runs a test. See #ChartedRun. */
static bool run_test(const void *context, size_t i, bool *has_chart, Error *error) {
    const TestRun *run = context;
    size_t index = i;
    return (run->options->argument_count == 0 ||
            command_find_test(run->options->arguments[i], &index, error)) &&
           lab_run_test(index, run->request, has_chart, error);
}

void cli_lab(const Options *options, Error *error) {
    LabRequest request = {.folder = options->out_dir,
                          .threads = command_threads(options),
                          .stop = interrupt_flag(),
                          .table_stream = options->quiet ? NULL : stdout};
    if (!options->out_dir) {
        error_set(error, STATUS_USAGE, "lab needs --out DIR: where its CSV and SVG files go");
        return;
    }
    // Misspelt names are reported before the first test runs.
    for (int i = 0; i < options->argument_count; i++) {
        size_t index;
        if (!command_find_test(options->arguments[i], &index, error)) {
            return;
        }
    }
    if (lab_create_folder(&request, error)) {
        const TestRun run = {options, &request};
        size_t named = (size_t)options->argument_count;
        command_run_each(options, PROGRESS_TESTS, named ? named : lab_test_count(), run_test, &run,
                         error);
    }
}
