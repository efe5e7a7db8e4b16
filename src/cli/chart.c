/**
 * @file
 * @brief `dioptre chart`: speed against accuracy.
 */
#include "lab/charts/chart.h"
#include "base/language.h"
#include "base/scene_name.h"
#include "cli/commands.h"

#include <stdio.h>
#include <string.h>

/**
 * Charts a scene.
 * @param[out] has_chart  Whether there is an SVG.
 * @return false on failure.
 */
static bool chart_scene(const Options *options, const char *path, const LabRequest *request,
                        bool *has_chart, Error *error) {
    Options one = *options;
    char name[256];
    one.arguments[0] = path;
    one.argument_count = 1;
    RenderSettings settings;
    Scene *scene = command_load_scene(&one, &settings, error);
    if (!scene) {
        return false;
    }
    Chart chart;
    scene_name_from_path(path, name, sizeof name);
    bool is_written = chart_measure(scene, &settings, request->stop, &chart, error) &&
                      chart_save(&chart, name, request, has_chart, error);
    scene_destroy(scene);
    return is_written;
}

/** @return Whether all scenes have different names, as the files are named after them. */
static bool check_names(const Options *options, Error *error) {
    char name[256], other[256];
    for (int i = 0; i < options->argument_count; i++) {
        scene_name_from_path(options->arguments[i], name, sizeof name);
        for (int j = 0; j < i; j++) {
            scene_name_from_path(options->arguments[j], other, sizeof other);
            if (strcmp(name, other) == 0) {
                return error_set(error, STATUS_USAGE, "'%s' and '%s' would have the same %s.csv",
                                 options->arguments[j], options->arguments[i], name);
            }
        }
    }
    return true;
}

/** The scenes of a command line. */
typedef struct SceneCharts {
    const Options *options;    /**< The command line. */
    const LabRequest *request; /**< What is asked of the charts. */
} SceneCharts;

/** Charts a scene. See #ChartedRun. */
static bool run_scene(const void *context, size_t i, bool *has_chart, Error *error) {
    const SceneCharts *charts = context;
    return chart_scene(charts->options, charts->options->arguments[i], charts->request, has_chart,
                       error);
}

/** Finds the tests whose methods are charted. @param options The command line: its arguments, or
 *  all tests. @param[out] indices Their indices. @return Number of tests; 0 on failure. */
static size_t find_timed_tests(const Options *options, size_t *indices, Error *error) {
    size_t count = 0;
    for (size_t i = 0; options->argument_count == 0 && i < lab_test_count(); i++) {
        if (lab_test_at(i).has_benchmark) {
            indices[count++] = i;
        }
    }
    for (int i = 0; i < options->argument_count; i++) {
        const char *name = options->arguments[i];
        if (!command_find_test(name, &indices[count], error)) {
            return 0;
        }
        if (!lab_test_at(indices[count]).has_benchmark) {
            error_set(error, STATUS_USAGE, "the methods of %s are timed in another test", name);
            return 0;
        }
        count++;
    }
    return count;
}

/** The methods that are charted. */
typedef struct MethodCharts {
    size_t indices[ARGUMENTS_MAXIMUM]; /**< The tests that have them. */
    const LabRequest *request;         /**< What is asked of the charts. */
} MethodCharts;

/** Charts the methods of a test. See #ChartedRun. */
static bool run_methods(const void *context, size_t i, bool *has_chart, Error *error) {
    const MethodCharts *charts = context;
    return lab_benchmark_test(charts->indices[i], charts->request, has_chart, error);
}

/** Charts methods. @return false on failure; finished charts are kept. */
static bool chart_methods(const Options *options, const LabRequest *request, Error *error) {
    MethodCharts charts = {.request = request};
    size_t count = find_timed_tests(options, charts.indices, error);
    return count > 0 && lab_create_folder(request, error) &&
           command_run_each(options, PROGRESS_CHARTS, count, run_methods, &charts, error);
}

void cli_chart(const Options *options, Error *error) {
    LabRequest request = {.folder = options->out_dir,
                          .threads = command_threads(options),
                          .stop = interrupt_flag(),
                          .table_stream = options->quiet ? NULL : stdout};
    if (!options->out_dir) {
        error_set(error, STATUS_USAGE, "chart needs --out DIR: where its CSV and SVG files go");
    } else if (options->kernels) {
        chart_methods(options, &request, error);
    } else if (options->argument_count == 0) {
        error_set(error, STATUS_USAGE, "chart needs a scene, or --kernels");
    } else if (check_names(options, error) && lab_create_folder(&request, error)) {
        const SceneCharts charts = {options, &request};
        command_run_each(options, PROGRESS_CHARTS, (size_t)options->argument_count, run_scene,
                         &charts, error);
    }
}
