/**
 * @file
 * @brief `dioptre lab`: where each method fails.
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

bool command_check_charts(size_t count, Error *error) {
    return count == 0 || error_set(error, STATUS_FAILED,
                                   "the CSV files are written; for the charts gnuplot is missing: "
                                   "sudo apt-get install %s",
                                   CHART_PACKAGE);
}

/** Makes the tests that a command line names, or all of them. @return false if anything is wrong: a
 *  chart that is missing, too. */
static bool run_tests(const Options *options, const LabRequest *request, Error *error) {
    size_t named = (size_t)options->argument_count, count = named ? named : lab_test_count();
    size_t without_chart = 0;
    for (size_t i = 0; i < count; i++) {
        size_t index = i;
        bool has_chart = false;
        if ((named && !command_find_test(options->arguments[i], &index, error)) ||
            !lab_run_test(index, request, &has_chart, error)) {
            return false;
        }
        without_chart += !has_chart;
    }
    return command_check_charts(without_chart, error);
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
        run_tests(options, &request, error);
    }
}
