/**
 * @file
 * @brief `dioptre chart`: speed against accuracy.
 */
#include "dioptre/chart.h"
#include "cli/commands.h"
#include "dioptre/language.h"
#include "dioptre/scene_name.h"

#include <stdio.h>
#include <string.h>

/** The package of the program that draws charts. */
#define CHART_PACKAGE "gnuplot-nox"

/**
 * Charts a scene.
 * @param options         The command line.
 * @param path            The scene's file.
 * @param request         Where to.
 * @param[out] has_chart  Whether there is an SVG.
 * @param[out] error      What is wrong.
 * @return false if anything is.
 */
static bool chart_scene(const Options *options, const char *path, const LabRequest *request,
                        bool *has_chart, Error *error) {
    Options one = *options;
    char name[256];
    one.arguments[0] = path;
    one.argument_count = 1;
    Scene *scene = command_scene(&one, error);
    if (!scene) {
        return false;
    }
    Chart chart;
    RenderSettings settings = command_settings(&one, scene);
    scene_name(path, name, sizeof name);
    bool is_kept = chart_measure(scene, &settings, request->stop, &chart, error) &&
                   chart_keep(&chart, name, request, has_chart, error);
    scene_destroy(scene);
    return is_kept;
}

/** Charts scenes. See #Command.run. @param options The command line. @param[out] error What is
 *  wrong; what was finished before is kept. @return The exit status. */
static int chart_run(const Options *options, Error *error) {
    LabRequest request = {.folder = options->folder,
                          .stop = interrupt_flag(),
                          .table = options->quiet ? NULL : stdout};
    size_t without_chart = 0;
    if (!options->folder) {
        error_set(error, STATUS_USAGE, "chart needs --out DIR: where its CSV and SVG files go");
        return STATUS_USAGE;
    }
    if (!lab_prepare(&request, error)) {
        return (int)error->status;
    }
    for (int i = 0; i < options->argument_count; i++) {
        bool has_chart = false;
        if (!chart_scene(options, options->arguments[i], &request, &has_chart, error)) {
            return (int)error->status;
        }
        without_chart += !has_chart;
    }
    if (without_chart > 0) {
        error_set(error, STATUS_FAILED,
                  "the CSV files are written; for the charts gnuplot is missing: "
                  "sudo apt-get install %s",
                  CHART_PACKAGE);
    }
    return (int)error->status;
}

const Command chart_command = {.name = "chart",
                               .usage = N_("SCENE... --out DIR"),
                               .help = N_("says what settings cost and what errors they leave"),
                               .accepts = "UsASDtjEOXBq",
                               .arguments = 1,
                               .more_arguments = true,
                               .run = chart_run};
