/**
 * @file
 * @brief What scenes need, tried on a sample of pixels and on all of them: the table of
 *        doc/needs.md.
 */
#include "dioptre/needs.h"
#include "dioptre/renderer.h"
#include "dioptre/script.h"

#include <stdio.h>
#include <string.h>

/** Width of the pictures that are tried: small, but whole. */
enum { TRIED_WIDTH = 320 };

/** @return What a scene needs. @param scene The scene. @param is_whole Whether all pixels are
 *  tried. @param[out] needs It. @param[out] error What is wrong. */
static bool find(const Scene *scene, bool is_whole, Needs *needs, Error *error) {
    RenderSettings settings = render_settings_default(scene);
    int height = TRIED_WIDTH * scene->image.height / scene->image.width;
    NeedsRequest request = {.width = TRIED_WIDTH,
                            .height = height,
                            .samples = settings.samples,
                            .depth = scene->image.depth,
                            .trace = &settings.trace,
                            .threads = settings.threads,
                            .is_whole = is_whole};
    return needs_find(scene, &request, needs, error);
}

/** Prints a scene's row. @param name The scene. @param pilot What a sample says. @param whole What
 *  all pixels say. */
static void row_print(const char *name, const Needs *pilot, const Needs *whole) {
    const NeedsEngine *chosen = &pilot->engines[pilot->engine];
    double seconds = pilot->engines[pilot->engine < 2 ? pilot->engine : 1].seconds;
    printf("| %s | %s, %.2g | %s, depth %d | %.2g | %zu of %zu | %.2g | %.2g %% | %.1f |\n", name,
           forecast_engine(&pilot->forecast)->name, forecast_steps(&pilot->forecast),
           chosen->engine->name, pilot->depth, pilot->total.worst,
           pilot->total.off + pilot->total.strays, pilot->total.rays, whole->engines[0].trial.worst,
           100 * (double)(whole->engines[0].trial.off + whole->engines[0].trial.strays) /
               (double)whole->engines[0].trial.rays,
           pilot->everything / seconds);
    fflush(stdout);
}

/** Tries scenes. @param argc Their number, and one. @param argv Their files. @return 1 if anything
 *  is wrong. */
int main(int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        Error error = {0};
        Needs pilot, whole;
        ScriptRequest request = {.path = argv[i],
                                 .seconds = SCRIPT_SECONDS,
                                 .memory = SCRIPT_MEMORY,
                                 .shape_keywords = engine_find("f32x1", NULL)->shape_keywords};
        Scene *scene = script_load(&request, &error);
        if (!scene || !find(scene, false, &pilot, &error) || !find(scene, true, &whole, &error)) {
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
