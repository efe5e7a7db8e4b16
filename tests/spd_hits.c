/**
 * @file
 * @brief Counts the camera rays that hit anything, for tests/spd.sh.
 *
 *     spd_hits FILE ENGINE...
 *
 * prints a line for each engine: its name, the number of hits, and the number of pixels in which
 * it differs from the first engine. An engine whose name begins with `edge:` traces only pixels
 * that have a neighbour of the other kind in the first engine's picture; elsewhere its result is
 * that of the first. For quad, this saves nine tenths of the time.
 */
#include "dioptre/engine.h"
#include "dioptre/renderer.h"
#include "dioptre/script.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Prefix of engines that trace only edges. */
#define EDGE_PREFIX "edge:"

/** Which pixels of a picture are hit. */
typedef struct HitMap {
    int width;    /**< Pixels. */
    int height;   /**< Pixels. */
    bool *is_hit; /**< Row by row; owned. */
} HitMap;

/** Prints an error and exits. */
_Noreturn static void fail(const char *message) {
    fprintf(stderr, "spd_hits: %s\n", message);
    exit(EXIT_FAILURE);
}

/** @return Memory for an array. */
static void *allocate(size_t count, size_t size) {
    void *memory = calloc(count, size);
    if (!memory) {
        fail("no memory");
    }
    return memory;
}

/** @return An empty map of a scene's picture. */
static HitMap hit_map_of(const Scene *scene) {
    int width = scene->image.width, height = scene->image.height;
    return (HitMap){width, height, allocate((size_t)width * (size_t)height, sizeof(bool))};
}

/** @return Whether a pixel has a neighbour, or itself, that differs from it. */
static bool is_edge(const HitMap *map, int x, int y) {
    bool center = map->is_hit[y * map->width + x];
    for (int j = -1; j <= 1; j++) {
        for (int i = -1; i <= 1; i++) {
            int u = x + i, v = y + j;
            bool is_inside = u >= 0 && v >= 0 && u < map->width && v < map->height;
            if (is_inside && map->is_hit[v * map->width + u] != center) {
                return true;
            }
        }
    }
    return false;
}

/** Traces all pixels. */
static void trace_all(const Engine *engine, const Tracer *tracer, HitMap *map) {
    size_t count = (size_t)map->width * (size_t)map->height;
    int *shapes = allocate(count, sizeof *shapes);
    double *distances = allocate(count, sizeof *distances);
    const PixelGrid grid = {.columns = map->width, .rows = map->height, .stride = 1};
    engine->trace_primary(tracer, &grid, shapes, distances);
    for (size_t i = 0; i < count; i++) {
        map->is_hit[i] = shapes[i] >= 0;
    }
    free(shapes);
    free(distances);
}

/** Traces the pixels at edges of another map. */
static void trace_edges(const Engine *engine, const Tracer *tracer, const HitMap *first,
                        HitMap *map) {
    for (int y = 0; y < map->height; y++) {
        for (int x = 0; x < map->width; x++) {
            bool *is_hit = &map->is_hit[y * map->width + x];
            *is_hit = first->is_hit[y * map->width + x];
            if (is_edge(first, x, y)) {
                int shape;
                double distance;
                const PixelGrid grid = {.x = x, .y = y, .columns = 1, .rows = 1, .stride = 1};
                engine->trace_primary(tracer, &grid, &shape, &distance);
                *is_hit = shape >= 0;
            }
        }
    }
}

/** Traces a scene in an engine, and prints its line. @param first Map of the first engine; NULL:
 *  this is the first. @return Its map. */
static HitMap trace_engine(const Scene *scene, const char *name, const HitMap *first) {
    Error error = {0};
    const size_t prefix = strlen(EDGE_PREFIX);
    bool at_edges = first && strncmp(name, EDGE_PREFIX, prefix) == 0;
    const Engine *engine = engine_find(at_edges ? name + prefix : name, &error);
    RenderSettings settings = render_settings_default(scene);
    Tracer *tracer = engine ? engine->create_tracer(scene, &settings.trace, &error) : NULL;
    if (!tracer) {
        fail(error.message);
    }
    HitMap map = hit_map_of(scene);
    engine->set_view(tracer, scene, map.width, map.height);
    if (at_edges) {
        trace_edges(engine, tracer, first, &map);
    } else {
        trace_all(engine, tracer, &map);
    }
    size_t hits = 0, differences = 0;
    for (size_t i = 0; i < (size_t)map.width * (size_t)map.height; i++) {
        hits += map.is_hit[i];
        if (first && map.is_hit[i] != first->is_hit[i]) {
            differences++;
            if (getenv("SPD_VERBOSE")) {
                printf("pixel %zu %zu: %d\n", i % (size_t)map.width, i / (size_t)map.width,
                       map.is_hit[i]);
            }
        }
    }
    printf("%s %zu %zu\n", engine->name, hits, differences);
    engine->destroy(tracer);
    return map;
}

/** Counts hits. @return EXIT_FAILURE if the scene cannot be read. */
int main(int argc, char **argv) {
    if (argc < 3) {
        fail("usage: spd_hits FILE ENGINE...");
    }
    Error error = {0};
    const ScriptRequest request = {
        .path = argv[1], .time_limit = SCRIPT_TIME_LIMIT, .memory_limit = SCRIPT_MEMORY_LIMIT};
    Scene *scene = script_load(&request, &error);
    if (!scene) {
        fail(error.message);
    }
    HitMap first = trace_engine(scene, argv[2], NULL);
    for (int i = 3; i < argc; i++) {
        HitMap map = trace_engine(scene, argv[i], &first);
        free(map.is_hit);
    }
    free(first.is_hit);
    scene_destroy(scene);
    return EXIT_SUCCESS;
}
