/**
 * @file
 * @brief The number of shapes from which a BVH pays: the same pictures with a BVH and without,
 *        alternately.
 *
 * Called by `make bench`: `tree ENGINE SCENE NAME`. The scene's `t` is its number of shapes. Prints
 * lines of CSV: engine, name, shapes, milliseconds without a BVH, milliseconds with a BVH, and the
 * lowest and the highest of their ratios. Times are the fastest of many, because the machine may be
 * shared.
 */
#include "dioptre/renderer.h"
#include "dioptre/script.h"

#include <stdio.h>

/** Rounds, and pictures per round. */
enum { TURNS = 5, FRAMES = 6 };

/** The measurements for one number of shapes. */
typedef struct ListBvhTimes {
    double list_seconds; /**< Fastest picture without a BVH, seconds. */
    double bvh_seconds;  /**< Fastest picture with a BVH, seconds. */
    double lowest;       /**< Lowest ratio of list to BVH in any round. */
    double highest;      /**< Highest ratio of list to BVH in any round. */
} ListBvhTimes;

/**
 * @return A renderer of one thread at 800 x 600; NULL on failure.
 * @param bvh_use  Whether shapes get a BVH.
 */
static Renderer *renderer_of(const Scene *scene, const Engine *engine, BvhMode bvh_use,
                             Error *error) {
    RenderSettings settings = render_settings_default(scene);
    settings.engine = engine;
    settings.threads = 1;
    settings.trace.bvh = bvh_use;
    return renderer_create(scene, &settings, error);
}

/** @return Seconds of the fastest of some pictures. */
static double fastest_picture(Renderer *renderer) {
    double fastest = renderer_render(renderer, NULL, NULL).seconds;
    for (int i = 1; i < FRAMES; i++) {
        double seconds = renderer_render(renderer, NULL, NULL).seconds;
        fastest = seconds < fastest ? seconds : fastest;
    }
    return fastest;
}

/**
 * @return The comparison of list and BVH.
 * @param list  The renderer without a BVH.
 */
static ListBvhTimes compare_renderers(Renderer *list, Renderer *tree) {
    ListBvhTimes result = {HUGE_VAL, HUGE_VAL, HUGE_VAL, 0};
    for (int i = 0; i < TURNS; i++) {
        double with_list = fastest_picture(list), with_tree = fastest_picture(tree);
        double ratio = with_list / with_tree;
        result.list_seconds = with_list < result.list_seconds ? with_list : result.list_seconds;
        result.bvh_seconds = with_tree < result.bvh_seconds ? with_tree : result.bvh_seconds;
        result.lowest = ratio < result.lowest ? ratio : result.lowest;
        result.highest = ratio > result.highest ? ratio : result.highest;
    }
    return result;
}

/** Measures a scene with one number of shapes. @return false on failure. */
static bool measure_shape_count(const char *path, const char *name, const Engine *engine,
                                int shapes, Error *error) {
    const ScriptRequest request = {.path = path,
                                   .time = shapes,
                                   .time_limit = SCRIPT_TIME_LIMIT,
                                   .memory_limit = SCRIPT_MEMORY_LIMIT};
    Scene *scene = script_load(&request, error);
    Renderer *list = scene ? renderer_of(scene, engine, BVH_NEVER, error) : NULL;
    Renderer *tree = list ? renderer_of(scene, engine, BVH_ALWAYS, error) : NULL;
    if (tree) {
        ListBvhTimes c = compare_renderers(list, tree);
        printf("%s,%s,%d,%.4g,%.4g,%.3f,%.3f,%.3f\n", engine->name, name, shapes,
               1e3 * c.list_seconds, 1e3 * c.bvh_seconds, c.list_seconds / c.bvh_seconds, c.lowest,
               c.highest);
    }
    renderer_destroy(tree);
    renderer_destroy(list);
    scene_destroy(scene);
    return tree != NULL;
}

/** Measures 4 to 256 shapes. @return 0 on success. */
int main(int count, char **arguments) {
    static const int numbers[] = {4,  6,  8,  10, 12, 16,  20,  24, 28,
                                  32, 40, 48, 64, 96, 128, 192, 256};
    Error error = {0};
    const Engine *engine = count == 4 ? engine_find(arguments[1], &error) : NULL;
    bool is_good = engine != NULL;
    for (size_t i = 0; is_good && i < sizeof numbers / sizeof *numbers; i++) {
        is_good = measure_shape_count(arguments[2], arguments[3], engine, numbers[i], &error);
    }
    if (!is_good) {
        fprintf(stderr, "tree: %s\n", engine || count == 4 ? error.message : "ENGINE SCENE NAME");
    }
    return is_good ? 0 : 1;
}
