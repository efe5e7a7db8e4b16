/**
 * @file
 * @brief The needs of scenes, on a sample of pixels and on all of them: the table of doc/needs.md.
 */
#include "lab/needs/needs.h"
#include "dioptre/renderer.h"
#include "dioptre/script.h"
#include "lab/needs/image_difference.h"

#include <stdio.h>
#include <string.h>

/** Width of the pictures. */
enum { TRIED_WIDTH = 320 };

/** Finds the needs of a scene. @return false on failure. */
static bool find_needs(const Scene *scene, Needs *needs, Error *error) {
    RenderSettings settings = render_settings_default(scene);
    int height = TRIED_WIDTH * scene->image.height / scene->image.width;
    NeedsRequest request = {.width = TRIED_WIDTH,
                            .height = height,
                            .samples = settings.samples,
                            .depth = scene->image.depth,
                            .trace = &settings.trace,
                            .threads = settings.threads,
                            .stop = NULL};
    return needs_find(scene, &request, needs, error);
}

/** Compares float with double for all pixels, at the depth needed. @return false on failure. */
static bool verify_float(const Scene *scene, int depth, NeedsTrial *trial, Error *error) {
    RenderSettings settings = render_settings_default(scene);
    PixelSet pixels;
    SampledRender render, truth;
    int height = TRIED_WIDTH * scene->image.height / scene->image.width;
    Variant variant = {
        .engine = engine_find("auto", NULL), .trace = settings.trace, .samples_traced = 1};
    variant.trace.depth = depth;
    variant.trace.samples = settings.samples;
    Variant reference = variant;
    reference.engine = engine_find("f64x1", NULL);
    if (!pixel_set_init(&pixels, TRIED_WIDTH, height, pixel_is_any, NULL, error)) {
        return false;
    }
    RenderContext render_context = {scene, &pixels, settings.threads, NULL};
    if (!render_samples(&render_context, &variant, &render, error) ||
        !render_samples(&render_context, &reference, &truth, error)) {
        return false;
    }
    ImageDifference difference =
        image_difference_of(&render, &truth, &truth, (Encoding)scene->image.encoding);
    *trial = (NeedsTrial){
        .rays = difference.rays, .max_steps = difference.max_steps, .visible = difference.visible};
    bool is_counted =
        outliers_count(&render_context, &reference, &truth, &render, &trial->outliers, error);
    sampled_render_deinit(&render);
    sampled_render_deinit(&truth);
    pixel_set_deinit(&pixels);
    return is_counted;
}

/** Prints a scene's row. @param whole The comparison of float with double on all pixels. */
static void row_print(const char *name, const Needs *sampled_needs, const NeedsTrial *whole) {
    const NeedsEngine *chosen = &sampled_needs->engines[sampled_needs->engine];
    double seconds =
        sampled_needs->engines[sampled_needs->engine < 2 ? sampled_needs->engine : 1].cpu_seconds;
    printf("| %s | %s, %.2g | %s, depth %d | %.2g | %zu of %zu | %.2g | %.2g %% | %.1f |\n", name,
           precision_estimate_engine(&sampled_needs->forecast)->name,
           precision_estimate_error(&sampled_needs->forecast), chosen->engine->name,
           sampled_needs->depth, sampled_needs->total_trial.max_steps,
           sampled_needs->total_trial.visible + sampled_needs->total_trial.outliers,
           sampled_needs->total_trial.rays, whole->max_steps,
           100 * (double)(whole->visible + whole->outliers) / (double)whole->rays,
           sampled_needs->reference_cpu_seconds / seconds);
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
        Needs sampled_needs;
        NeedsTrial whole;
        ScriptRequest request = {
            .path = argv[i], .time_limit = SCRIPT_TIME_LIMIT, .memory_limit = SCRIPT_MEMORY_LIMIT};
        Scene *scene = script_load(&request, &error);
        if (!scene || !find_needs(scene, &sampled_needs, &error) ||
            !verify_float(scene, sampled_needs.depth, &whole, &error)) {
            fprintf(stderr, "%s: %s\n", argv[i], error.message);
            scene_destroy(scene);
            return 1;
        }
        const char *slash = strrchr(argv[i], '/');
        row_print(slash ? slash + 1 : argv[i], &sampled_needs, &whole);
        scene_destroy(scene);
    }
    return 0;
}
