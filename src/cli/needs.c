/**
 * @file
 * @brief `dioptre needs`: the cheapest settings whose error nobody can see.
 */
#include "dioptre/needs.h"
#include "base/language.h"
#include "cli/commands.h"
#include "dioptre/offset_strategy.h"

#include <libintl.h>
#include <stdio.h>

/** Prints what was tried, for programs. */
static void trial_print_json(const char *name, const NeedsTrial *trial) {
    printf(", \"%s\": {\"rays\": %zu, \"worst\": %.4g, \"off\": %zu, \"flips\": %zu, "
           "\"strays\": %zu}",
           name, trial->rays, trial->max_steps, trial->visible, trial->edge_flips, trial->outliers);
}

/** Prints it for programs. */
static void needs_print_json(const Needs *needs, const Options *options) {
    const NeedsEngine *chosen = &needs->engines[needs->engine];
    char explanation[2048];
    needs_explain(needs, explanation, sizeof explanation);
    printf("{\"scene\": ");
    json_print_string(options->arguments[0], stdout);
    printf(", \"engine\": \"%s\", \"depth\": %d, \"samples\": %d, \"offset\": \"bound\", "
           "\"tolerance\": %g, \"forecast_engine\": \"%s\", \"forecast_steps\": %.4g, "
           "\"forecast_depth\": %d, \"pilot_steps\": %.4g, \"worst_step\": %.4g, "
           "\"share_off\": %.4g, \"seconds\": %.6g, \"everything_seconds\": %.6g",
           chosen->engine->name, needs->depth, needs->samples, needs->tolerance,
           precision_estimate_engine(&needs->forecast)->name,
           precision_estimate_error(&needs->forecast), needs->forecast.depth,
           needs->engines[0].trial.max_steps, needs->total_trial.max_steps,
           (double)(needs->total_trial.visible + needs->total_trial.outliers) /
               (double)needs->total_trial.rays,
           needs->engines[needs->engine < 2 ? needs->engine : 1].cpu_seconds,
           needs->reference_cpu_seconds);
    trial_print_json("float", &needs->engines[0].trial);
    trial_print_json("at_depth", &needs->depth_trial);
    trial_print_json("offset_none", &needs->offset_none_trial);
    trial_print_json("offset_fixed", &needs->offset_fixed_trial);
    trial_print_json("total", &needs->total_trial);
    printf(", \"why\": ");
    json_print_string(explanation, stdout);
    puts("}");
}

/** Prints a paragraph in lines. */
static void paragraph_print(const char *text) {
    /** Characters of a line. */
    const int width = 79;
    int column = 0;
    while (*text) {
        int length = 0;
        while (text[length] && text[length] != ' ') {
            length++;
        }
        if (column > 0 && column + 1 + length > width) {
            putchar('\n');
            column = 0;
        }
        printf("%s%.*s", column > 0 ? " " : "", length, text);
        column += length + (column > 0);
        text += length + (text[length] == ' ');
    }
    putchar('\n');
}

/** Prints it for people. */
static void needs_print(const Needs *needs) {
    const NeedsEngine *chosen = &needs->engines[needs->engine];
    char explanation[2048];
    needs_explain(needs, explanation, sizeof explanation);
    printf(gettext("engine     %s\n"), chosen->engine->name);
    printf(gettext("depth      %d\n"), needs->depth);
    printf(gettext("offset     %s\n"), offset_strategy_names[OFFSET_BOUND]);
    printf(gettext("samples    %d\n"), needs->samples);
    if (needs->has_sdf) {
        printf(gettext("tolerance  %g times the scene's\n"), needs->tolerance);
    }
    printf(gettext("forecast   %s: float is off by %.2g steps\n"),
           precision_estimate_engine(&needs->forecast)->name,
           precision_estimate_error(&needs->forecast));
    printf(gettext("pilot      %.2g steps at most, %zu of %zu rays off; %zu edges moved, %zu by "
                   "more than 1/64 pixel\n"),
           needs->total_trial.max_steps, needs->total_trial.visible, needs->total_trial.rays,
           needs->total_trial.edge_flips, needs->total_trial.outliers);
    if (needs->total_trial.visible + needs->total_trial.outliers == 0) {
        printf(gettext("certainty  fewer than 1 in %.0f rays are off, with 95 %%\n"),
               needs_trial_certainty(&needs->total_trial));
    }
    putchar('\n');
    paragraph_print(explanation);
}

/** Says what a scene needs. See #Command.run. @return The exit status. */
static int needs_run(const Options *options, Error *error) {
    Scene *scene = command_load_scene(options, error);
    if (!scene) {
        return (int)error->status;
    }
    Needs needs;
    RenderSettings settings = command_render_settings(options, scene);
    NeedsRequest request = {.width = settings.width,
                            .height = settings.height,
                            .samples = settings.samples,
                            .depth = options->depth >= 0 ? options->depth : scene->image.depth,
                            .trace = &settings.trace,
                            .threads = settings.threads,
                            .stop = interrupt_flag()};
    if (needs_find(scene, &request, &needs, error)) {
        options->json ? needs_print_json(&needs, options) : needs_print(&needs);
    }
    scene_destroy(scene);
    return (int)error->status;
}

const Command needs_command = {.name = "needs",
                               .usage = N_("SCENE"),
                               .help = N_("says the cheapest settings whose error nobody can see"),
                               .accepts = "sADtjXBJq",
                               .arguments = 1,
                               .run = needs_run};
