/**
 * @file
 * @brief The laboratory.
 */
#include "dioptre/lab.h"

#include "lab/gnuplot.h"
#include "lab/kernel.h"
#include "lab/report.h"

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

LabTest lab_test(size_t place) {
    const Experiment *experiment = experiment_list()[place];
    return (LabTest){experiment->name, experiment->title, experiment->timed != 0};
}

bool lab_prepare(const LabRequest *request, Error *error) {
    struct stat found;
    if (mkdir(request->folder, 0777) != 0 && errno != EEXIST) {
        return error_set(error, STATUS_FAILED, "cannot make the folder '%s': %s", request->folder,
                         error_system(errno));
    }
    if (stat(request->folder, &found) != 0 || !S_ISDIR(found.st_mode)) {
        return error_set(error, STATUS_FAILED, "'%s' is no folder", request->folder);
    }
    return access(request->folder, W_OK | X_OK) == 0 ||
           error_set(error, STATUS_FAILED, "cannot write into the folder '%s': %s", request->folder,
                     error_system(errno));
}

/** Puts a path together. @param request In its folder. @param experiment Of what.
 *  @param ending Of its name. @param[out] path The path. @param[out] error That it is too long.
 *  @return Whether there is room for it. */
static bool make_path(const LabRequest *request, const Experiment *experiment, const char *ending,
                      char path[PATH_MAX], Error *error) {
    int length = snprintf(path, PATH_MAX, "%s/%s.%s", request->folder, experiment->name, ending);
    return (length > 0 && length < PATH_MAX) ||
           error_set(error, STATUS_FAILED, "the folder's name is too long");
}

/** Keeps what was found. @param experiment The experiment. @param findings It. @param request How.
 *  @param[out] has_chart Whether there is an SVG. @param[out] error What is wrong.
 *  @return false if anything is wrong. */
static bool keep(const Experiment *experiment, const Findings *findings, const LabRequest *request,
                 bool *has_chart, Error *error) {
    char csv[PATH_MAX], svg[PATH_MAX];
    if (request->table) {
        report_print(experiment, findings, request->table);
    }
    if (!make_path(request, experiment, "csv", csv, error) ||
        !make_path(request, experiment, "svg", svg, error) ||
        !report_write(experiment, findings, csv, error)) {
        return false;
    }
    *has_chart = gnuplot_is_there();
    return !*has_chart ||
           report_draw(experiment, findings, &(ChartFiles){csv, svg}, request->stop, error);
}

bool lab_make(size_t place, const LabRequest *request, bool *has_chart, Error *error) {
    const Experiment *experiment = experiment_list()[place];
    Findings findings;
    *has_chart = false;
    if (!experiment_make(experiment, request->threads, request->stop, &findings, error)) {
        return false;
    }
    bool is_kept = keep(experiment, &findings, request, has_chart, error);
    findings_release(&findings);
    return is_kept;
}

bool lab_time(size_t place, const LabRequest *request, bool *has_chart, Error *error) {
    const Experiment *experiment = experiment_list()[place];
    Kernel kernel;
    *has_chart = false;
    return kernel_measure(experiment, request->threads, request->stop, &kernel, error) &&
           kernel_keep(&kernel, experiment, request, has_chart, error);
}
