/**
 * @file
 * @brief `dioptre needs`: the cheapest settings for an error, or the best picture within a time.
 */
#include "lab/needs/needs.h"
#include "base/json.h"
#include "base/language.h"
#include "cli/commands.h"
#include "dioptre/scene.h"

#include <libintl.h>
#include <stdio.h>

/** Significant digits of errors in JSON, and of settings and times. */
enum { ERROR_DIGITS = 4, SETTING_DIGITS = 6 };

/** Longest explanation, bytes with its final zero. */
enum { EXPLANATION_SIZE = 8192 };

/* --- JSON --------------------------------------------------------------------------------------
 */

/** Writes one trial as a JSON object. */
static void trial_write_json(JsonWriter *json, const char *name, const NeedsTrial *trial) {
    json_object_begin(json, name);
    json_count(json, "pixels", trial->pixels);
    json_count(json, "off", trial->off);
    json_number(json, "worst_step", trial->max_steps, ERROR_DIGITS);
    json_number(json, "rms_steps", trial->rms_steps, ERROR_DIGITS);
    json_object_end(json);
}

/** Writes settings as members of a JSON object. */
static void settings_write_json(JsonWriter *json, const NeedsSettings *settings) {
    json_string(json, "engine", settings->engine->name);
    json_integer(json, "depth", settings->depth);
    json_number(json, "cutoff", settings->cutoff, SETTING_DIGITS);
    json_string(json, "offset", offset_strategy_names[settings->offset]);
    json_integer(json, "samples", settings->samples);
    json_number(json, "tolerance", settings->tolerance, SETTING_DIGITS);
}

/** Writes the checks as a JSON array. */
static void checks_write_json(JsonWriter *json, const Needs *needs) {
    json_array_begin(json, "checks");
    for (int i = 0; i < needs->check_count; i++) {
        const NeedsCheck *check = &needs->checks[i];
        json_object_begin(json, NULL);
        json_string(json, "reference", check->reference->name);
        json_integer(json, "width", check->width);
        json_integer(json, "height", check->height);
        json_integer(json, "samples", check->samples);
        trial_write_json(json, "trial", &check->trial);
        json_object_end(json);
    }
    json_array_end(json);
}

/** Writes what whole pictures refuted as a JSON array. */
static void corrections_write_json(JsonWriter *json, const Needs *needs) {
    json_array_begin(json, "corrections");
    for (int i = 0; i < needs->correction_count; i++) {
        const NeedsCorrection *correction = &needs->corrections[i];
        json_object_begin(json, NULL);
        settings_write_json(json, &correction->before);
        trial_write_json(json, "trial", &correction->trial);
        trial_write_json(json, "without", &correction->without);
        json_object_end(json);
    }
    json_array_end(json);
}

/** Writes the noise of rays per pixel as a JSON array. */
static void noise_write_json(JsonWriter *json, const Needs *needs) {
    json_array_begin(json, "noise");
    for (int i = 0; i < needs->noise_count; i++) {
        json_object_begin(json, NULL);
        json_integer(json, "samples", needs->noise[i].samples);
        trial_write_json(json, "trial", &needs->noise[i].trial);
        json_object_end(json);
    }
    json_array_end(json);
}

/** Writes the best picture within a time as a JSON object. */
static void budget_write_json(JsonWriter *json, const NeedsBudget *budget, double milliseconds) {
    json_object_begin(json, "budget");
    json_number(json, "milliseconds", milliseconds, SETTING_DIGITS);
    json_bool(json, "is_met", budget->is_met);
    settings_write_json(json, &budget->settings);
    json_number(json, "milliseconds_taken", 1e3 * budget->seconds, SETTING_DIGITS);
    json_bool(json, "is_measured", budget->is_measured);
    json_integer(json, "reference_samples", budget->reference_samples);
    trial_write_json(json, "error", &budget->trial);
    trial_write_json(json, "error_without_noise", &budget->without_noise);
    json_object_end(json);
}

/** Writes what single settings leave out. */
static void trials_write_json(JsonWriter *json, const Needs *needs) {
    trial_write_json(json, "float", &needs->float_trial);
    trial_write_json(json, "at_depth", &needs->depth_trial);
    trial_write_json(json, "at_cutoff", &needs->cutoff_trial);
    trial_write_json(json, "at_tolerance", &needs->tolerance_trial);
    trial_write_json(json, "offset_none", &needs->offset_trials[OFFSET_NONE]);
    trial_write_json(json, "offset_fixed", &needs->offset_trials[OFFSET_FIXED]);
}

/** Prints the result as JSON. */
static void needs_print_json(const Needs *needs, const Options *options) {
    char explanation[EXPLANATION_SIZE];
    const NeedsTrial *worst = &needs->checks[needs->check_count - 1].trial;
    JsonWriter json = {.stream = stdout};
    needs_explain(needs, explanation, sizeof explanation);
    json_object_begin(&json, NULL);
    json_string(&json, "scene", options->arguments[0]);
    settings_write_json(&json, &needs->settings);
    json_number(&json, "error", needs->error_steps, SETTING_DIGITS);
    json_bool(&json, "is_refuted", needs_is_refuted(needs));
    json_bool(&json, "is_noise_sufficient", needs->is_noise_sufficient);
    json_string(&json, "estimated_engine", precision_estimate_engine(&needs->forecast)->name);
    json_number(&json, "estimated_error", precision_estimate_error(&needs->forecast), ERROR_DIGITS);
    json_integer(&json, "estimated_depth", needs->forecast.depth);
    json_number(&json, "worst_step", worst->max_steps, ERROR_DIGITS);
    json_number(&json, "share_off", (double)worst->off / (double)worst->pixels, ERROR_DIGITS);
    json_number(&json, "milliseconds", 1e3 * needs->seconds, SETTING_DIGITS);
    json_number(&json, "reference_ratio", needs->reference_ratio, ERROR_DIGITS);
    checks_write_json(&json, needs);
    corrections_write_json(&json, needs);
    trials_write_json(&json, needs);
    noise_write_json(&json, needs);
    if (options->budget > 0) {
        budget_write_json(&json, &needs->budget, options->budget);
    }
    json_string(&json, "explanation", explanation);
    json_line_end(&json);
}

/* --- text --------------------------------------------------------------------------------------
 */

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

/** Prints settings, one per line. */
static void settings_print(const NeedsSettings *settings, bool has_sdf) {
    printf(gettext("engine     %s\n"), settings->engine->name);
    printf(gettext("depth      %d\n"), settings->depth);
    printf(gettext("cutoff     %g\n"), settings->cutoff);
    printf(gettext("offset     %s\n"), offset_strategy_names[settings->offset]);
    printf(gettext("samples    %d\n"), settings->samples);
    if (has_sdf) {
        printf(gettext("tolerance  %g times the scene's\n"), settings->tolerance);
    }
}

/** Prints a check. */
static void check_print(const NeedsCheck *check, double error_steps) {
    printf(ngettext("check      %d x %d pixels, %d ray each, against %s with everything on: ",
                    "check      %d x %d pixels, %d rays each, against %s with everything on: ",
                    (unsigned long)check->samples),
           check->width, check->height, check->samples, check->reference->name);
    printf(gettext("%zu of %zu pixels off by %g steps or more, by up to %.2g\n"), check->trial.off,
           check->trial.pixels, error_steps, check->trial.max_steps);
}

/** Prints how long a picture takes. */
static void time_print(double seconds, const NeedsRequest *request) {
    printf(ngettext("time       %.3g ms for %d x %d pixels with %d thread\n",
                    "time       %.3g ms for %d x %d pixels with %d threads\n",
                    (unsigned long)request->threads),
           1e3 * seconds, request->width, request->height, request->threads);
}

/** Prints the result as text. */
static void needs_print(const Needs *needs, const NeedsRequest *request) {
    char explanation[EXPLANATION_SIZE];
    needs_explain(needs, explanation, sizeof explanation);
    settings_print(&needs->settings, needs->has_sdf);
    time_print(needs->seconds, request);
    printf(gettext("forecast   %s: float is off by %.2g steps\n"),
           precision_estimate_engine(&needs->forecast)->name,
           precision_estimate_error(&needs->forecast));
    for (int i = 0; i < needs->check_count; i++) {
        check_print(&needs->checks[i], needs->error_steps);
    }
    putchar('\n');
    paragraph_print(explanation);
}

/** Prints the best picture within a time as text. */
static void budget_print(const Needs *needs, const NeedsRequest *request) {
    const NeedsBudget *budget = &needs->budget;
    settings_print(&budget->settings, needs->has_sdf);
    time_print(budget->seconds, request);
    printf(gettext("error      %.3g steps, root mean square; %zu of %zu pixels off by %g steps or "
                   "more, by up to %.2g\n"),
           budget->trial.rms_steps, budget->trial.off, budget->trial.pixels, needs->error_steps,
           budget->trial.max_steps);
    printf(gettext("noise      without it %.3g steps, root mean square, and %zu pixels off\n"),
           budget->without_noise.rms_steps, budget->without_noise.off);
    if (!budget->is_met) {
        printf(gettext("\nNo settings draw this picture within %g ms: these are the fastest.\n"),
               1e3 * request->budget_seconds);
    }
}

/* --- progress ----------------------------------------------------------------------------------
 */

/** The line that says what is tried now. */
typedef struct NeedsProgress {
    bool is_wanted; /**< Whether it is asked for. */
    bool is_json;   /**< Whether as JSON: an object per line. */
    bool is_shown;  /**< Whether there is a line to clear. */
} NeedsProgress;

/** Is a NeedsRequest::report: says what is tried now. */
static void progress_print(void *context, const char *stage) {
    NeedsProgress *progress = context;
    if (progress->is_json) {
        JsonWriter json = {.stream = stderr};
        json_object_begin(&json, NULL);
        json_string(&json, "stage", stage);
        json_line_end(&json);
    } else if (progress->is_wanted) {
        fprintf(stderr, "\r%s...\033[K", gettext(stage));
        fflush(stderr);
        progress->is_shown = true;
    }
}

/** Clears that line. */
static void progress_clear(const NeedsProgress *progress) {
    if (progress->is_shown) {
        fputs("\r\033[K", stderr);
    }
}

void cli_needs(const Options *options, Error *error) {
    if (options->error > 0 && options->budget > 0) {
        error_set(error, STATUS_USAGE, "needs takes --error or --budget, not both");
        return;
    }
    RenderSettings settings;
    Scene *scene = command_load_scene(options, &settings, error);
    if (!scene) {
        return;
    }
    Needs needs;
    const bool is_wanted = progress_is_wanted(options);
    NeedsProgress progress = {.is_wanted = is_wanted,
                              .is_json = is_wanted && options->progress == PROGRESS_JSON};
    NeedsRequest request = {.width = settings.width,
                            .height = settings.height,
                            .samples = settings.samples,
                            .depth = options->depth >= 0 ? options->depth : scene->image.depth,
                            .trace = &settings.trace,
                            .threads = settings.threads,
                            .error_steps = options->error > 0 ? options->error : NEEDS_ERROR_STEPS,
                            .budget_seconds = 1e-3 * options->budget,
                            .stop = interrupt_flag(),
                            .report = progress_print,
                            .context = &progress};
    bool is_found = needs_find(scene, &request, &needs, error);
    progress_clear(&progress);
    if (is_found && options->json) {
        needs_print_json(&needs, options);
    } else if (is_found && !options->quiet) {
        options->budget > 0 ? budget_print(&needs, &request) : needs_print(&needs, &request);
    }
    scene_destroy(scene);
}
