/**
 * @file
 * @brief The pixels of scenes with acne or a leak, in float: figures of README.md.
 */
#include "dioptre/renderer.h"
#include "dioptre/script.h"

#include <stdio.h>
#include <string.h>

/** Pixels of the pictures. */
enum { TRIED_WIDTH = 800, TRIED_HEIGHT = 600 };

/** Measures a scene's layer of acne, in float with the offset by the error bound. @return false on
 *  failure. */
static bool measure_acne(const Scene *scene, LayerStats *stats, Error *error) {
    RenderSettings settings = render_settings_default(scene);
    settings.width = TRIED_WIDTH;
    settings.height = TRIED_HEIGHT;
    settings.engine = engine_find("f32x8", error);
    settings.samples = 1;
    settings.trace.offset = OFFSET_BOUND;
    if (!settings.engine) {
        return false;
    }
    Renderer *renderer = renderer_create(scene, &settings, error);
    bool is_measured =
        renderer && renderer_measure_layer(renderer, scene, LAYER_ACNE, NULL, stats, error);
    renderer_destroy(renderer);
    return is_measured;
}

/**
 * Prints a row per scene: its name, pixels, pixels with acne, pixels with a leak.
 * @param argc  Number of scenes, plus one.
 * @return 1 on failure.
 */
int main(int argc, char **argv) {
    for (int i = 1; i < argc; i++) {
        Error error = {0};
        LayerStats stats;
        ScriptRequest request = {
            .path = argv[i], .time_limit = SCRIPT_TIME_LIMIT, .memory_limit = SCRIPT_MEMORY_LIMIT};
        Scene *scene = script_load(&request, &error);
        bool is_measured = scene && measure_acne(scene, &stats, &error);
        scene_destroy(scene);
        if (!is_measured) {
            fprintf(stderr, "%s: %s\n", argv[i], error.message);
            return 1;
        }
        const char *slash = strrchr(argv[i], '/');
        printf("%s,%llu,%llu,%llu\n", slash ? slash + 1 : argv[i],
               (unsigned long long)stats.pixel_count, (unsigned long long)stats.artifact_pixels,
               (unsigned long long)stats.leak_pixels);
        fflush(stdout);
    }
    return 0;
}
