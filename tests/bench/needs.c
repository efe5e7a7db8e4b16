/**
 * @file
 * @brief What scenes need, tried on a sample of pixels and on all of them: the table of
 *        doc/needs.md.
 */
#include "dioptre/needs.h"
#include "dioptre/renderer.h"
#include "dioptre/script.h"
#include "lab/strays.h"

#include <stdio.h>
#include <string.h>

/** Width of the pictures that are tried: small, but whole. */
enum { TRIED_WIDTH = 320 };

/** @return What a scene needs. @param scene The scene. @param[out] needs It. @param[out] error What
 * is wrong. */
static bool find(const Scene *scene, Needs *needs, Error *error) {
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

/** Compares float with double for all pixels, as deep as is needed. @param scene The scene.
 *  @param depth How deep. @param[out] trial How float does. @param[out] error What is wrong.
 *  @return false if anything is. */
static bool verify(const Scene *scene, int depth, NeedsTrial *trial, Error *error) {
    RenderSettings settings = render_settings_default(scene);
    Pixels pixels;
    Shot shot, truth;
    int height = TRIED_WIDTH * scene->image.height / scene->image.width;
    Manner manner = {.engine = engine_find("auto", NULL), .trace = settings.trace, .rays = 1};
    manner.trace.depth = depth;
    manner.trace.samples = settings.samples;
    Manner reference = manner;
    reference.engine = engine_find("f64x1", NULL);
    if (!pixels_make(&pixels, TRIED_WIDTH, height, pixel_is_any, NULL, error)) {
        return false;
    }
    Studio studio = {scene, &pixels, settings.threads, NULL};
    if (!shot_take(&studio, &manner, &shot, error) ||
        !shot_take(&studio, &reference, &truth, error)) {
        return false;
    }
    Contrast contrast = contrast_of(&shot, &truth, &truth, (Encoding)scene->image.encoding);
    *trial = (NeedsTrial){.rays = contrast.rays, .worst = contrast.worst, .off = contrast.off};
    bool is_counted = strays_count(&studio, &reference, &truth, &shot, &trial->strays, error);
    shot_release(&shot);
    shot_release(&truth);
    pixels_release(&pixels);
    return is_counted;
}

/** Prints a scene's row. @param name The scene. @param pilot What a sample says. @param whole What
 *  all pixels say of float. */
static void row_print(const char *name, const Needs *pilot, const NeedsTrial *whole) {
    const NeedsEngine *chosen = &pilot->engines[pilot->engine];
    double seconds = pilot->engines[pilot->engine < 2 ? pilot->engine : 1].seconds;
    printf("| %s | %s, %.2g | %s, depth %d | %.2g | %zu of %zu | %.2g | %.2g %% | %.1f |\n", name,
           forecast_engine(&pilot->forecast)->name, forecast_steps(&pilot->forecast),
           chosen->engine->name, pilot->depth, pilot->total.worst,
           pilot->total.off + pilot->total.strays, pilot->total.rays, whole->worst,
           100 * (double)(whole->off + whole->strays) / (double)whole->rays,
           pilot->everything / seconds);
    fflush(stdout);
}

/** Tries scenes. @param argc Their number, and one. @param argv Their files. @return 1 if anything
 *  is wrong. */
int main(int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        Error error = {0};
        Needs pilot;
        NeedsTrial whole;
        ScriptRequest request = {.path = argv[i],
                                 .seconds = SCRIPT_SECONDS,
                                 .memory = SCRIPT_MEMORY,
                                 .shape_keywords = engine_find("f32x1", NULL)->shape_keywords};
        Scene *scene = script_load(&request, &error);
        if (!scene || !find(scene, &pilot, &error) || !verify(scene, pilot.depth, &whole, &error)) {
            fprintf(stderr, "%s: %s\n", argv[i], error.message);
            scene_destroy(scene);
            return 1;
        }
        const char *slash = strrchr(argv[i], '/');
        row_print(slash ? slash + 1 : argv[i], &pilot, &whole);
        scene_destroy(scene);
    }
    return 0;
}
