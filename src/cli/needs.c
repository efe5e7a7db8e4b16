/**
 * @file
 * @brief `dioptre needs`: the cheapest settings whose error nobody can see.
 */
#include "dioptre/needs.h"
#include "cli/commands.h"
#include "dioptre/language.h"
#include "dioptre/offset.h"

#include <libintl.h>
#include <stdio.h>

/** Prints what was tried, for programs. @param name Its name. @param trial It. */
static void trial_print_json(const char *name, const NeedsTrial *trial) {
    printf(", \"%s\": {\"rays\": %zu, \"worst\": %.4g, \"off\": %zu, \"flips\": %zu, "
           "\"strays\": %zu}",
           name, trial->rays, trial->worst, trial->off, trial->flips, trial->strays);
}

/** Prints it for programs. @param needs What a scene needs. @param options The command line. */
static void needs_print_json(const Needs *needs, const Options *options) {
    const NeedsEngine *chosen = &needs->engines[needs->engine];
    char words[2048];
    needs_explain(needs, words, sizeof words);
    printf("{\"scene\": ");
    json_print_string(options->arguments[0], stdout);
    printf(", \"engine\": \"%s\", \"depth\": %d, \"samples\": %d, \"offset\": \"bound\", "
           "\"tolerance\": %g, \"forecast_engine\": \"%s\", \"forecast_steps\": %.4g, "
           "\"forecast_depth\": %d, \"pilot_steps\": %.4g, \"worst_step\": %.4g, "
           "\"share_off\": %.4g, \"seconds\": %.6g, \"everything_seconds\": %.6g",
           chosen->engine->name, needs->depth, needs->samples, needs->tolerance,
           forecast_engine(&needs->forecast)->name, forecast_steps(&needs->forecast),
           needs->forecast.depth, needs->engines[0].trial.worst, needs->total.worst,
           (double)(needs->total.off + needs->total.strays) / (double)needs->total.rays,
           needs->engines[needs->engine < 2 ? needs->engine : 1].seconds, needs->everything);
    trial_print_json("float", &needs->engines[0].trial);
    trial_print_json("at_depth", &needs->at_depth);
    trial_print_json("offset_none", &needs->offset_none);
    trial_print_json("offset_fixed", &needs->offset_fixed);
    trial_print_json("total", &needs->total);
    printf(", \"why\": ");
    json_print_string(words, stdout);
    puts("}");
}

/** Prints a paragraph in lines. @param words It. */
static void paragraph_print(const char *words) {
    /** Characters of a line. */
    const int width = 79;
    int column = 0;
    while (*words) {
        int length = 0;
        while (words[length] && words[length] != ' ') {
            length++;
        }
        if (column > 0 && column + 1 + length > width) {
            putchar('\n');
            column = 0;
        }
        printf("%s%.*s", column > 0 ? " " : "", length, words);
        column += length + (column > 0);
        words += length + (words[length] == ' ');
    }
    putchar('\n');
}

/** Prints it for people. @param needs What a scene needs. */
static void needs_print(const Needs *needs) {
    const NeedsEngine *chosen = &needs->engines[needs->engine];
    char words[2048];
    needs_explain(needs, words, sizeof words);
    printf(gettext("engine     %s\n"), chosen->engine->name);
    printf(gettext("depth      %d\n"), needs->depth);
    printf(gettext("offset     %s\n"), offset_names[OFFSET_BOUND]);
    printf(gettext("samples    %d\n"), needs->samples);
    if (needs->is_marched) {
        printf(gettext("tolerance  %g times the scene's\n"), needs->tolerance);
    }
    printf(gettext("forecast   %s: float is off by %.2g steps\n"),
           forecast_engine(&needs->forecast)->name, forecast_steps(&needs->forecast));
    printf(gettext("pilot      %.2g steps at most, %zu of %zu rays off; %zu edges moved, %zu by "
                   "more than 1/64 pixel\n"),
           needs->total.worst, needs->total.off, needs->total.rays, needs->total.flips,
           needs->total.strays);
    if (needs->total.off + needs->total.strays == 0) {
        printf(gettext("certainty  fewer than 1 in %.0f rays are off, with 95 %%\n"),
               needs_certainty(&needs->total));
    }
    putchar('\n');
    paragraph_print(words);
}

/** Says what a scene needs. See #Command.run. @param options The command line.
 *  @param[out] error What is wrong. @return The exit status. */
static int needs_run(const Options *options, Error *error) {
    Scene *scene = command_scene(options, error);
    if (!scene) {
        return (int)error->status;
    }
    Needs needs;
    RenderSettings settings = command_settings(options, scene);
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
