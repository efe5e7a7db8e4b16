/**
 * @file
 * @brief The needs of scenes: the table of doc/needs.md.
 */
#include "lab/needs/needs.h"
#include "dioptre/renderer.h"
#include "dioptre/script.h"

#include <stdio.h>
#include <string.h>

/** Width of the pictures. */
enum { TRIED_WIDTH = 320 };

/** Finds the needs of a scene, with one ray per pixel. @return false on failure. */
static bool find_needs(const Scene *scene, Needs *needs, Error *error) {
    RenderSettings settings = render_settings_default(scene);
    int height = TRIED_WIDTH * scene->image.height / scene->image.width;
    NeedsRequest request = {.width = TRIED_WIDTH,
                            .height = height,
                            .samples = 1,
                            .depth = scene->image.depth,
                            .trace = &settings.trace,
                            .threads = settings.threads,
                            .error_steps = NEEDS_ERROR_STEPS};
    return needs_find(scene, &request, needs, error);
}

/** Prints a trial as two cells: what is off most, and the percentage of the pixels. */
static void trial_print(const NeedsTrial *trial) {
    printf(" %.2g | %.2g %% |", trial->max_steps, 100 * (double)trial->off / (double)trial->pixels);
}

/** Prints a scene's row. */
static void row_print(const char *name, const Needs *needs) {
    const NeedsCheck *check = &needs->checks[needs->check_count - 1];
    printf("| %s | %s, %.2g | %s, depth %d |", name,
           precision_estimate_engine(&needs->forecast)->name,
           precision_estimate_error(&needs->forecast), needs->settings.engine->name,
           needs->settings.depth);
    printf(" %s, %d x %d |", check->reference->name, check->width, check->height);
    trial_print(&check->trial);
    trial_print(&needs->float_trial);
    printf(" %d | %.1f |\n", needs->correction_count, needs->double_over_float_seconds);
    fflush(stdout);
}

/**
 * Finds the needs of scenes.
 * @param argc  Number of scenes, plus one.
 * @return 1 on failure.
 */
int main(int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        Error error = {0};
        Needs needs;
        ScriptRequest request = {
            .path = argv[i], .time_limit = SCRIPT_TIME_LIMIT, .memory_limit = SCRIPT_MEMORY_LIMIT};
        Scene *scene = script_load(&request, &error);
        if (!scene || !find_needs(scene, &needs, &error)) {
            fprintf(stderr, "%s: %s\n", argv[i], error.message);
            scene_destroy(scene);
            return 1;
        }
        const char *slash = strrchr(argv[i], '/');
        row_print(slash ? slash + 1 : argv[i], &needs);
        scene_destroy(scene);
    }
    return 0;
}
