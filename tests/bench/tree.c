/**
 * @file
 * @brief From how many shapes on a tree pays: the same pictures with a tree and without, in turns.
 *
 * Called by `make bench`: `tree ENGINE SCENE NAME`. The scene holds as many shapes as its `t` says.
 * Prints lines of CSV: engine, name, shapes, milliseconds as a list, milliseconds with a tree, and
 * the lowest and the highest of their ratios. The machine may be shared, so the times are the
 * fastest of many.
 */
#include "dioptre/renderer.h"
#include "dioptre/script.h"

#include <stdio.h>

/** Turns that are taken, and pictures a turn. */
enum { TURNS = 5, FRAMES = 6 };

/** What was measured of one number of shapes. */
typedef struct Match {
    double list;    /**< Fastest picture without a tree, seconds. */
    double tree;    /**< Fastest picture with a tree, seconds. */
    double lowest;  /**< Lowest ratio of list to tree of any turn. */
    double highest; /**< Highest ratio of list to tree of any turn. */
} Match;

/** @return A renderer of one thread at 800 x 600; NULL if anything is wrong. @param scene The
 * scene.
 *  @param engine The engine. @param tree Whether there is a tree. @param[out] error What is wrong.
 */
static Renderer *renderer_of(const Scene *scene, const Engine *engine, TreeUse tree, Error *error) {
    RenderSettings settings = render_settings_default(scene);
    settings.engine = engine;
    settings.threads = 1;
    settings.trace.tree = tree;
    return renderer_create(scene, &settings, error);
}

/** @return Seconds of the fastest of some pictures. @param renderer Draws them. */
static double turn_take(Renderer *renderer) {
    double fastest = renderer_draw(renderer, NULL, NULL).seconds;
    for (int i = 1; i < FRAMES; i++) {
        double seconds = renderer_draw(renderer, NULL, NULL).seconds;
        fastest = seconds < fastest ? seconds : fastest;
    }
    return fastest;
}

/** @return How list and tree compare. @param list Draws without a tree. @param tree Draws with. */
static Match renderers_compare(Renderer *list, Renderer *tree) {
    Match result = {HUGE_VAL, HUGE_VAL, HUGE_VAL, 0};
    for (int i = 0; i < TURNS; i++) {
        double with_list = turn_take(list), with_tree = turn_take(tree);
        double ratio = with_list / with_tree;
        result.list = with_list < result.list ? with_list : result.list;
        result.tree = with_tree < result.tree ? with_tree : result.tree;
        result.lowest = ratio < result.lowest ? ratio : result.lowest;
        result.highest = ratio > result.highest ? ratio : result.highest;
    }
    return result;
}

/** Measures a scene with one number of shapes. @param path The scene. @param name Its name.
 *  @param engine The engine. @param shapes How many. @param[out] error What is wrong.
 *  @return false if anything is. */
static bool number_measure(const char *path, const char *name, const Engine *engine, int shapes,
                           Error *error) {
    const ScriptRequest request = {.path = path,
                                   .time = shapes,
                                   .seconds = SCRIPT_SECONDS,
                                   .memory = SCRIPT_MEMORY,
                                   .shape_keywords = engine->shape_keywords};
    Scene *scene = script_load(&request, error);
    Renderer *list = scene ? renderer_of(scene, engine, TREE_NEVER, error) : NULL;
    Renderer *tree = list ? renderer_of(scene, engine, TREE_ALWAYS, error) : NULL;
    if (tree) {
        Match c = renderers_compare(list, tree);
        printf("%s,%s,%d,%.4g,%.4g,%.3f,%.3f,%.3f\n", engine->name, name, shapes, 1e3 * c.list,
               1e3 * c.tree, c.list / c.tree, c.lowest, c.highest);
    }
    renderer_destroy(tree);
    renderer_destroy(list);
    scene_destroy(scene);
    return tree != NULL;
}

/** Measures 4 to 256 shapes. @param count 4. @param arguments Engine, scene, name. @return 0 when
 *  all is done. */
int main(int count, char **arguments) {
    static const int numbers[] = {4,  6,  8,  10, 12, 16,  20,  24, 28,
                                  32, 40, 48, 64, 96, 128, 192, 256};
    Error error = {0};
    const Engine *engine = count == 4 ? engine_find(arguments[1], &error) : NULL;
    bool is_good = engine != NULL;
    for (size_t i = 0; is_good && i < sizeof numbers / sizeof *numbers; i++) {
        is_good = number_measure(arguments[2], arguments[3], engine, numbers[i], &error);
    }
    if (!is_good) {
        fprintf(stderr, "tree: %s\n", engine || count == 4 ? error.message : "ENGINE SCENE NAME");
    }
    return is_good ? 0 : 1;
}
