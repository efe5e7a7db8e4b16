/**
 * @file
 * @brief `dioptre lab`: where each method fails.
 */
#include "dioptre/lab.h"
#include "cli/commands.h"
#include "dioptre/language.h"
#include "script/suggest.h"

#include <stdio.h>
#include <string.h>

/** The package of the program that draws charts. */
#define CHART_PACKAGE "gnuplot-nox"

bool command_test(const char *name, size_t *place, Error *error) {
    char known[ERROR_MESSAGE_SIZE] = "", hint[SUGGEST_HINT_SIZE];
    Suggestion suggestion = {.wanted = name};
    for (size_t i = 0; i < lab_test_count(); i++) {
        const char *test = lab_test(i).name;
        if (strcmp(test, name) == 0) {
            *place = i;
            return true;
        }
        suggest_try(&suggestion, test);
        size_t length = strlen(known);
        snprintf(known + length, sizeof known - length, "%s%s", i ? ", " : "", test);
    }
    return error_set(error, STATUS_USAGE, "there is no test '%s'%s; there are %s", name,
                     suggest_hint(&suggestion, hint), known);
}

int command_threads(const Options *options) {
    return options->threads ? options->threads : render_processors();
}

bool command_has_charts(size_t count, Error *error) {
    return count == 0 || error_set(error, STATUS_FAILED,
                                   "the CSV files are written; for the charts gnuplot is missing: "
                                   "sudo apt-get install %s",
                                   CHART_PACKAGE);
}

/**
 * Makes the tests that a command line names, or all of them.
 * @param options     The command line.
 * @param request     How.
 * @param[out] error  What is wrong.
 * @return false if anything is wrong: a chart that is missing, too.
 */
static bool make_tests(const Options *options, const LabRequest *request, Error *error) {
    size_t named = (size_t)options->argument_count, count = named ? named : lab_test_count();
    size_t without_chart = 0;
    for (size_t i = 0; i < count; i++) {
        size_t place = i;
        bool has_chart = false;
        if ((named && !command_test(options->arguments[i], &place, error)) ||
            !lab_make(place, request, &has_chart, error)) {
            return false;
        }
        without_chart += !has_chart;
    }
    return command_has_charts(without_chart, error);
}

/** Makes tests. See #Command.run. @param options The command line. @param[out] error What is wrong.
 *  @return The exit status. */
static int lab_run(const Options *options, Error *error) {
    LabRequest request = {.folder = options->folder,
                          .threads = command_threads(options),
                          .stop = interrupt_flag(),
                          .table = options->quiet ? NULL : stdout};
    if (!options->folder) {
        error_set(error, STATUS_USAGE, "lab needs --out DIR: where its CSV and SVG files go");
        return STATUS_USAGE;
    }
    // Misspelt names are said before any work is done.
    for (int i = 0; i < options->argument_count; i++) {
        size_t place;
        if (!command_test(options->arguments[i], &place, error)) {
            return STATUS_USAGE;
        }
    }
    if (lab_prepare(&request, error)) {
        make_tests(options, &request, error);
    }
    return (int)error->status;
}

const Command lab_command = {.name = "lab",
                             .usage = N_("[TEST...] --out DIR"),
                             .help = N_("says where each method fails"),
                             .accepts = "Ujq",
                             .arguments = 0,
                             .more_arguments = true,
                             .run = lab_run};
