/**
 * @file
 * @brief The time and the accuracy of sphere tracing: the same picture with steps of several
 *        lengths, and with footprints of several sizes, alternately.
 *
 * Called by `make bench`: `marching ENGINE SCENE...`. Prints lines of CSV: scene, varied setting,
 * its value, processor time of the fastest of many pictures in milliseconds, per cent of the pixels
 * that differ by more than one 8-bit step, and the largest difference in steps. The reference is a
 * picture in double without over-relaxation and without a footprint.
 */
#include "dioptre/renderer.h"
#include "dioptre/script.h"

#include <stdio.h>
#include <time.h>

/** Number of rounds. */
enum { TURNS = 3 };

/** Settings of sphere tracing. */
typedef struct SphereTracingSetting {
    const char *what;  /**< Name of the varied setting. */
    double value;      /**< Its value. */
    double relaxation; /**< See #TraceSettings.relaxation. */
    double footprint;  /**< See #TraceSettings.footprint. */
} SphereTracingSetting;

/** All measured settings. */
static const SphereTracingSetting settings_tried[] = {
    {"relaxation", 1, 1, 0},
    {"relaxation", 1.2, 1.2, 0},
    {"relaxation", 1.6, 1.6, 0},
    {"relaxation", 0, 0, 0},
    {"footprint", 0.03125, 0, 0.03125},
    {"footprint", 0.0625, 0, 0.0625},
    {"footprint", 0.125, 0, 0.125},
    {"footprint", 0.25, 0, 0.25},
    {"footprint", 0.5, 0, 0.5},
};
/** Number of settings. */
enum { SETTING_COUNT = sizeof settings_tried / sizeof *settings_tried };

/** @return A renderer of the scene's size, one ray per pixel, one thread; NULL on failure. */
static Renderer *renderer_of(const Scene *scene, const Engine *engine, SphereTracingSetting log,
                             Error *error) {
    RenderSettings settings = render_settings_default(scene);
    settings.engine = engine;
    settings.threads = 1;
    settings.samples = 1;
    settings.trace.relaxation = log.relaxation;
    settings.trace.footprint = log.footprint;
    return renderer_create(scene, &settings, error);
}

/** @return Processor time of a picture, seconds, because the machine may be shared. */
static double picture_cpu_seconds(Renderer *renderer) {
    clock_t start = clock();
    renderer_render(renderer, NULL, NULL);
    return (double)(clock() - start) / CLOCKS_PER_SEC;
}

/** @return The scene of a file; NULL on failure. */
static Scene *scene_of(const char *path, Error *error) {
    const ScriptRequest request = {
        .path = path, .time_limit = SCRIPT_TIME_LIMIT, .memory_limit = SCRIPT_MEMORY_LIMIT};
    return script_load(&request, error);
}

/**
 * Measures all settings.
 * @param renderers  One per setting.
 * @param[in,out] picture  A buffer for a picture.
 */
static void measure_settings(const char *path, Renderer **renderers, const Picture *truth,
                             Picture *picture) {
    double fastest[SETTING_COUNT];
    for (int turn = 0; turn < TURNS; turn++) {
        for (int i = 0; i < SETTING_COUNT; i++) {
            double seconds = picture_cpu_seconds(renderers[i]);
            fastest[i] = turn == 0 || seconds < fastest[i] ? seconds : fastest[i];
        }
    }
    for (int i = 0; i < SETTING_COUNT; i++) {
        renderer_render(renderers[i], NULL, picture);
        PictureComparison c = picture_compare(picture, truth, NULL);
        printf("%s,%s,%g,%.4g,%.4f,%d\n", path, settings_tried[i].what, settings_tried[i].value,
               1e3 * fastest[i], 100 * c.differing_fraction, c.max_difference);
        fflush(stdout);
    }
}

/** Measures a scene. @return false on failure. */
static bool measure_scene(const char *path, const Engine *engine, Error *error) {
    const SphereTracingSetting truly = {"truth", 0, 1, 0};
    Renderer *renderers[SETTING_COUNT] = {NULL}, *truth = NULL;
    Picture reference = {0}, picture = {0};
    Scene *scene = scene_of(path, error);
    bool is_good = scene && (truth = renderer_of(scene, engine_find("f64x4", error), truly, error));
    for (int i = 0; i < SETTING_COUNT && is_good; i++) {
        is_good = (renderers[i] = renderer_of(scene, engine, settings_tried[i], error)) != NULL;
    }
    is_good = is_good && picture_init(&reference, scene->image.width, scene->image.height, error) &&
              picture_init(&picture, scene->image.width, scene->image.height, error);
    if (is_good) {
        renderer_render(truth, NULL, &reference);
        measure_settings(path, renderers, &reference, &picture);
    }
    for (int i = 0; i < SETTING_COUNT; i++) {
        renderer_destroy(renderers[i]);
    }
    renderer_destroy(truth);
    picture_deinit(&reference);
    picture_deinit(&picture);
    scene_destroy(scene);
    return is_good;
}

/** Measures scenes. @return 0 on success. */
int main(int count, char **arguments) {
    Error error = {0};
    const Engine *engine = count > 2 ? engine_find(arguments[1], &error) : NULL;
    bool is_good = engine != NULL;
    for (int i = 2; is_good && i < count; i++) {
        is_good = measure_scene(arguments[i], engine, &error);
    }
    if (!is_good) {
        fprintf(stderr, "marching: %s\n", count > 2 ? error.message : "ENGINE SCENE...");
    }
    return is_good ? 0 : 1;
}
