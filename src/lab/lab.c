/**
 * @file
 * @brief Runs and saves the experiments of the laboratory.
 */
#include "dioptre/lab.h"

#include "lab/charts/experiment_report.h"
#include "lab/charts/gnuplot.h"
#include "lab/microbenchmark.h"

#include <errno.h>
#include <limits.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

size_t lab_test_count(void) {
    size_t count = 0;
    while (experiment_list()[count]) {
        count++;
    }
    return count;
}

LabTest lab_test_at(size_t index) {
    const Experiment *experiment = experiment_list()[index];
    return (LabTest){experiment->name, experiment->title, experiment->timed_level != 0};
}

/** Makes the folders above a path, where they are missing. */
static void make_folders_above(const char *path) {
    char above[PATH_MAX];
    for (const char *slash = strchr(path, '/'); slash; slash = strchr(slash + 1, '/')) {
        int length = (int)(slash - path);
        if (length > 0 && length < PATH_MAX) {
            snprintf(above, sizeof above, "%.*s", length, path);
            mkdir(above, 0777); // Where this fails, the last one fails too, and says why.
        }
    }
}

bool lab_create_folder(const LabRequest *request, Error *error) {
    struct stat found;
    make_folders_above(request->folder);
    if (mkdir(request->folder, 0777) != 0 && errno != EEXIST) {
        return error_set(error, STATUS_FAILED, "cannot make the folder '%s': %s", request->folder,
                         error_errno_text(errno));
    }
    if (stat(request->folder, &found) != 0 || !S_ISDIR(found.st_mode)) {
        return error_set(error, STATUS_FAILED, "'%s' is no folder", request->folder);
    }
    return access(request->folder, W_OK | X_OK) == 0 ||
           error_set(error, STATUS_FAILED, "cannot write into the folder '%s': %s", request->folder,
                     error_errno_text(errno));
}

/** Makes the path of a result. @return false if it is too long. */
static bool result_path(const LabRequest *request, const Experiment *experiment, const char *ending,
                        char path[PATH_MAX], Error *error) {
    int length = snprintf(path, PATH_MAX, "%s/%s.%s", request->folder, experiment->name, ending);
    return (length > 0 && length < PATH_MAX) ||
           error_set(error, STATUS_FAILED, "the folder's name is too long");
}

/** Saves results. @param[out] has_chart Whether the SVG is written. @return false if anything is
 *  wrong. */
static bool save_results(const Experiment *experiment, const ExperimentResults *results,
                         const LabRequest *request, bool *has_chart, Error *error) {
    char csv[PATH_MAX], svg[PATH_MAX];
    if (request->table_stream) {
        experiment_report_print(experiment, results, request->table_stream);
    }
    if (!result_path(request, experiment, "csv", csv, error) ||
        !result_path(request, experiment, "svg", svg, error) ||
        !experiment_report_write_csv(experiment, results, csv, error)) {
        return false;
    }
    *has_chart = gnuplot_is_available();
    return !*has_chart || experiment_report_draw(experiment, results, &(ReportPaths){csv, svg},
                                                 request->stop, error);
}

bool lab_run_test(size_t index, const LabRequest *request, bool *has_chart, Error *error) {
    const Experiment *experiment = experiment_list()[index];
    ExperimentResults results;
    *has_chart = false;
    if (!experiment_run(experiment, request->threads, request->stop, &results, error)) {
        return false;
    }
    bool is_saved = save_results(experiment, &results, request, has_chart, error);
    experiment_results_deinit(&results);
    return is_saved;
}

bool lab_benchmark_test(size_t index, const LabRequest *request, bool *has_chart, Error *error) {
    const Experiment *experiment = experiment_list()[index];
    Microbenchmark benchmark;
    *has_chart = false;
    return microbenchmark_measure(experiment, request->threads, request->stop, &benchmark, error) &&
           microbenchmark_save(&benchmark, experiment, request, has_chart, error);
}
