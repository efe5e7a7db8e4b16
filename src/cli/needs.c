/**
 * @file
 * @brief `dioptre needs`: the fastest settings without a visible error.
 */
#include "lab/needs/needs.h"
#include "base/json.h"
#include "base/language.h"
#include "cli/commands.h"
#include "dioptre/scene.h"

#include <libintl.h>
#include <stdio.h>

/** Significant digits of errors and shares in JSON. */
enum { ERROR_DIGITS = 4 };

/** Writes the error of one trial as a JSON object. */
static void trial_write_json(JsonWriter *json, const char *name, const NeedsTrial *trial) {
    json_object_begin(json, name);
    json_count(json, "rays", trial->rays);
    json_number(json, "worst_step", trial->max_steps, ERROR_DIGITS);
    json_count(json, "visible", trial->visible);
    json_count(json, "edge_flips", trial->edge_flips);
    json_count(json, "outliers", trial->outliers);
    json_object_end(json);
}

/** Prints the result as JSON. */
static void needs_print_json(const Needs *needs, const Options *options) {
    /** Significant digits of settings and times. */
    const int digits = 6;
    const NeedsEngine *chosen = &needs->engines[needs->engine];
    size_t off = needs->total_trial.visible + needs->total_trial.outliers;
    char explanation[2048];
    JsonWriter json = {.stream = stdout};
    needs_explain(needs, explanation, sizeof explanation);
    json_object_begin(&json, NULL);
    json_string(&json, "scene", options->arguments[0]);
    json_string(&json, "engine", chosen->engine->name);
    json_integer(&json, "depth", needs->depth);
    json_integer(&json, "samples", needs->samples);
    json_string(&json, "offset", offset_strategy_names[OFFSET_BOUND]);
    json_number(&json, "tolerance", needs->tolerance, digits);
    json_string(&json, "estimated_engine", precision_estimate_engine(&needs->forecast)->name);
    json_number(&json, "estimated_error", precision_estimate_error(&needs->forecast), ERROR_DIGITS);
    json_integer(&json, "estimated_depth", needs->forecast.depth);
    json_number(&json, "measured_error", needs->engines[0].trial.max_steps, ERROR_DIGITS);
    json_number(&json, "worst_step", needs->total_trial.max_steps, ERROR_DIGITS);
    json_number(&json, "share_off", (double)off / (double)needs->total_trial.rays, ERROR_DIGITS);
    json_number(&json, "seconds", needs->engines[needs->engine < 2 ? needs->engine : 1].cpu_seconds,
                digits);
    json_number(&json, "search_seconds", needs->reference_cpu_seconds, digits);
    trial_write_json(&json, "float", &needs->engines[0].trial);
    trial_write_json(&json, "at_depth", &needs->depth_trial);
    trial_write_json(&json, "offset_none", &needs->offset_none_trial);
    trial_write_json(&json, "offset_fixed", &needs->offset_fixed_trial);
    trial_write_json(&json, "total", &needs->total_trial);
    json_string(&json, "explanation", explanation);
    json_line_end(&json);
}

/** Prints a paragraph, wrapped. */
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

/** Prints the result as text. */
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

void cli_needs(const Options *options, Error *error) {
    Scene *scene = command_load_scene(options, error);
    if (!scene) {
        return;
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
}
