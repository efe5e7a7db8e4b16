/**
 * @file
 * @brief What the tests share: assertions that say what was measured, random numbers, ulps, small
 *        scenes.
 */
#ifndef DIOPTRE_TESTING_H
#define DIOPTRE_TESTING_H

#include "lab/quad.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

/** Fails unless a measured value is at most a bound, and says both. NaN fails. */
#define assert_at_most(value, bound, ...)                                                          \
    do {                                                                                           \
        double measured_ = (double)(value), bound_ = (double)(bound);                              \
        if (!(measured_ <= bound_)) {                                                              \
            char what_[256];                                                                       \
            snprintf(what_, sizeof what_, __VA_ARGS__);                                            \
            fail_msg("%s: %g, at most %g allowed", what_, measured_, bound_);                      \
        }                                                                                          \
    } while (0)

/** @return A number, uniform in 0 to 1. @param[in,out] state A generator (splitmix64). */
static inline double random_share(uint64_t *state) {
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/** @return A number rounded to float. Kept in memory: gcc 12 leaves out both conversions where it
 * makes vectors of them (-O3 with -fno-trapping-math). @param x It. */
static inline double as_float(double x) {
    volatile float rounded = (float)x;
    return (double)rounded;
}

/** @return A number, uniform in a range and exact in float. @param[in,out] state A generator.
 *  @param low Lowest. @param high Highest. */
static inline double random_float(uint64_t *state, double low, double high) {
    return as_float(low + (high - low) * random_share(state));
}

/** @return Half an ulp of 1 of an engine's number type. @param engine The engine. */
static inline Quadruple roundoff(const Engine *engine) {
    Quadruple u = 1;
    for (int i = 0; i < engine->mantissa_bits; i++) {
        u /= 2;
    }
    return u;
}

/** As the scene language says a sphere. */
typedef struct SphereParameters {
    Vector3 center; /**< Centre. */
    double radius;  /**< Radius. */
} SphereParameters;

/** As the scene language says a plane. */
typedef struct PlaneParameters {
    Vector3 point;  /**< A point. */
    Vector3 normal; /**< Its normal. */
} PlaneParameters;

/** As the scene language says a quad. */
typedef struct QuadParameters {
    Vector3 corner; /**< A corner. */
    Vector3 u;      /**< To the next. */
    Vector3 v;      /**< To the other next. */
} QuadParameters;

/** As the scene language says a box. */
typedef struct BoxParameters {
    Vector3 low;  /**< Lowest corner. */
    Vector3 high; /**< Highest corner. */
} BoxParameters;

/** As the scene language says a cylinder. */
typedef struct CylinderParameters {
    Vector3 base;  /**< Centre of one end. */
    Vector3 top;   /**< Of the other. */
    double radius; /**< Radius. */
    bool capped;   /**< Whether the ends are closed. */
} CylinderParameters;

/** As the scene language says a triangle. */
typedef struct TriangleParameters {
    Vector3 corners[3]; /**< Corners. */
    Vector3 normals[3]; /**< Normals there. */
    Pair places[3];     /**< Places in a picture there. */
    bool is_smooth;     /**< Whether the normals count. */
} TriangleParameters;

/** @return An empty scene with a camera at the origin that looks along -z; to be given back. Its
 *          depth is said: tracers are asked, and not what scenes need. */
static inline Scene *empty_scene(void) {
    Error error = {0};
    Scene *scene = scene_create(&error);
    assert_non_null(scene);
    scene->image.depth = 5;
    scene->camera = *(const Camera *)camera_keyword.defaults;
    return scene;
}

/** Adds a shape of the newest material. @param scene The scene. @param name The shape's keyword.
 *  @param parameters As the scene language says it. */
static inline void add_shape(Scene *scene, const char *name, const void *parameters) {
    const Keyword *const *keywords = engine_list()[0]->shape_keywords;
    size_t kind = 0;
    while (keywords[kind] && strcmp(keywords[kind]->name, name) != 0) {
        kind++;
    }
    assert_non_null(keywords[kind]);
    Error error = {0};
    size_t material = scene->material_count - 1;
    assert_true(scene_add_shape(scene, kind, keywords[kind], parameters, material, &error));
}

/** How the scene language says the surface of a field. */
typedef struct SdfRow {
    const Field *field; /**< The field. */
    double tolerance;   /**< How near is on it. */
    int max_steps;      /**< After so many a ray is given up. */
} SdfRow;

/** Adds the surface of a field to a scene. @param scene The scene. @param row It; copied. */
static inline void add_sdf(Scene *scene, SdfRow row) {
    Error error = {0};
    row.field = scene_keep_field(scene, row.field, &error);
    assert_non_null(row.field);
    add_shape(scene, "sdf", &row);
}

/** How the scene language says a mesh. */
typedef struct MeshRow {
    size_t file; /**< Place of its model in the scene. */
    int normals; /**< 0: the file's; 1: smooth; 2: flat. */
} MeshRow;

/**
 * Adds a mesh of its own file to a scene.
 * @param scene           The scene.
 * @param positions       The corners.
 * @param position_count  How many.
 * @param triangles       Places of corners.
 * @param triangle_count  How many triangles.
 * @param normals         See #MeshRow.
 */
static inline void add_mesh(Scene *scene, const Vector3 *positions, size_t position_count,
                            const MeshTriangle *triangles, size_t triangle_count, int normals) {
    Error error = {0};
    char name[32];
    snprintf(name, sizeof name, "%zu", scene->mesh_count);
    SceneFile file = {.path = name, .name = name, .where = "test:1"};
    MeshRow row = {.normals = normals};
    assert_true(scene_add_mesh(scene, &file, &row.file, &error));
    Mesh counts = {.position_count = position_count, .triangle_count = triangle_count};
    Mesh *mesh = mesh_create(&counts, &error);
    assert_non_null(mesh);
    memcpy(mesh->positions, positions, position_count * sizeof *positions);
    memcpy(mesh->triangles, triangles, triangle_count * sizeof *triangles);
    scene->meshes[row.file].mesh = mesh;
    add_shape(scene, "mesh", &row);
}

/** @return A tracer as deep as the scene's picture, to be given back. @param engine The engine.
 *  @param scene The scene. @param tree Whether its shapes get a tree. */
static inline Tracer *prepare_with_tree(const Engine *engine, const Scene *scene, TreeUse tree) {
    Error error = {0};
    TraceSettings settings = {.depth = scene->image.depth, .offset = OFFSET_BOUND, .tree = tree};
    Tracer *tracer = engine->prepare(scene, &settings, &error);
    assert_non_null(tracer);
    return tracer;
}

/** @return The same, with a tree where it pays. @param engine The engine. @param scene The scene.
 */
static inline Tracer *prepare(const Engine *engine, const Scene *scene) {
    return prepare_with_tree(engine, scene, TREE_AUTO);
}

/** Traces the one pixel of a picture of one. @param engine The engine. @param scene The scene.
 *  @param[out] rgb Its linear light. @return The rays that it took. */
static inline RayCounts trace_pixel(const Engine *engine, const Scene *scene, double rgb[3]) {
    PixelGrid grid = {.columns = 1, .rows = 1, .stride = 1};
    RayCounts counts = {0};
    Tracer *tracer = prepare(engine, scene);
    engine->look(tracer, scene, 1, 1);
    engine->trace(tracer, &grid, rgb, &counts);
    engine->release(tracer);
    return counts;
}

/** Rays that are asked at once. */
enum { BATCH = 4096 };

/** @return How many rays to ask: the reference engine is a hundred times slower. @param engine It.
 *  @param count For the others. */
static inline long scaled(const Engine *engine, long count) {
    return engine->mantissa_bits > 64 ? count / 100 : count;
}

/** @return A ray from one point towards another. @param from Where. @param to Where to. */
static inline RayQuery ray_towards(Vector3 from, Vector3 to) {
    return (RayQuery){{from.x, from.y, from.z}, {to.x - from.x, to.y - from.y, to.z - from.z}};
}

/** A test of one engine. @param engine The engine. */
typedef void (*EngineTest)(const Engine *engine);

/** Runs a test in every engine that this machine can run. @param test The test. */
static inline void in_every_engine(EngineTest test) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if (engine_is_supported(*engine)) {
            test(*engine);
        }
    }
}

#endif
