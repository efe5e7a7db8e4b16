/**
 * @file
 * @brief Shared helpers of the tests: assertions that print measured values, random numbers,
 *        rounding, small scenes.
 */
#ifndef DIOPTRE_TESTING_H
#define DIOPTRE_TESTING_H

#include "lab/vec3q.h"
#include "workload.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

/** Number of items of an array. */
#define COUNT(array) (sizeof(array) / sizeof *(array))

/** Fails unless a measured value is at most a bound, and prints both. NaN fails. */
#define assert_at_most(value, bound, ...)                                                          \
    do {                                                                                           \
        double measured_ = (double)(value), bound_ = (double)(bound);                              \
        if (!(measured_ <= bound_)) {                                                              \
            char what_[256];                                                                       \
            snprintf(what_, sizeof what_, __VA_ARGS__);                                            \
            fail_msg("%s: %g, at most %g allowed", what_, measured_, bound_);                      \
        }                                                                                          \
    } while (0)

/** @return A random number, uniform in 0 to 1. */
static inline double random_unit_double(uint64_t *state) {
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/**
 * @return A number rounded to float. The variable is volatile: gcc 12 removes both conversions
 *         where it vectorises them (-O3 with -fno-trapping-math).
 */
static inline double round_to_float(double x) {
    volatile float rounded = (float)x;
    return (double)rounded;
}

/** @return A random number, uniform in a range and exact in float. */
static inline double random_float(uint64_t *state, double low, double high) {
    return round_to_float(low + (high - low) * random_unit_double(state));
}

/** @return Half an ulp of 1 in an engine's number type. */
static inline Quadruple roundoff(const Engine *engine) {
    Quadruple u = 1;
    for (int i = 0; i < engine->mantissa_bits; i++) {
        u /= 2;
    }
    return u;
}

/**
 * @return An empty scene with a camera at the origin that looks along -z; to be destroyed. Its
 *         depth is set, so that it is not chosen automatically.
 */
static inline Scene *create_empty_scene(void) {
    Error error = {0};
    Scene *scene = scene_create(&error);
    assert_non_null(scene);
    scene->image.depth = 5;
    scene->camera = *(const SceneCamera *)scene_camera_keyword.defaults;
    return scene;
}

/** Adds a shape of the newest material. @param parameters In the layout of the scene language. */
static inline void add_shape(Scene *scene, const char *name, const void *parameters) {
    size_t kind = scene_shape_find(name);
    const Keyword *keyword = scene_shape_keywords[kind];
    assert_non_null(keyword);
    Error error = {0};
    size_t material = scene->material_count - 1;
    assert_true(scene_add_shape(scene, kind, keyword, parameters, material, &error));
}

/** Adds the surface of a field to a scene. */
static inline void add_sdf(Scene *scene, SdfShapeParameters row) {
    Error error = {0};
    row.field = scene_add_sdf(scene, row.field, &error);
    assert_non_null(row.field);
    add_shape(scene, "sdf", &row);
}

/** Adds a mesh to a scene. */
static inline void add_mesh(Scene *scene, const Vec3d *positions, size_t position_count,
                            const MeshTriangle *triangles, size_t triangle_count, int normals) {
    Error error = {0};
    char name[32];
    snprintf(name, sizeof name, "%zu", scene->mesh_count);
    SceneFile file = {.path = name, .name = name, .location = "test:1"};
    MeshShapeParameters row = {.normals = normals};
    assert_true(scene_add_mesh(scene, &file, &row.file, &error));
    Mesh counts = {.position_count = position_count, .triangle_count = triangle_count};
    Mesh *mesh = mesh_create(&counts, &error);
    assert_non_null(mesh);
    memcpy(mesh->positions, positions, position_count * sizeof *positions);
    memcpy(mesh->triangles, triangles, triangle_count * sizeof *triangles);
    mesh_update_bounds(mesh);
    scene->meshes[row.file].mesh = mesh;
    add_shape(scene, "mesh", &row);
}

/**
 * @return A tracer with the depth of the scene's picture, to be destroyed.
 * @param bvh_use  Whether its shapes get a BVH.
 */
static inline Tracer *create_tracer_with_bvh(const Engine *engine, const Scene *scene,
                                             BvhMode bvh_use) {
    Error error = {0};
    TraceSettings settings = {.depth = scene->image.depth, .offset = OFFSET_BOUND, .bvh = bvh_use};
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    assert_non_null(tracer);
    return tracer;
}

/** @return The same, with a BVH where it pays. */
static inline Tracer *create_tracer(const Engine *engine, const Scene *scene) {
    return create_tracer_with_bvh(engine, scene, BVH_AUTO);
}

/** Traces a picture of one pixel. @return The number of rays. */
static inline RayCounts trace_pixel(const Engine *engine, const Scene *scene, double rgb[3]) {
    PixelGrid grid = {.columns = 1, .rows = 1, .stride = 1};
    RayCounts counts = {0};
    Tracer *tracer = create_tracer(engine, scene);
    engine->set_view(tracer, scene, 1, 1);
    engine->trace(tracer, &grid, rgb, &counts);
    engine->destroy(tracer);
    return counts;
}

/** Rays per query. */
enum { BATCH = 4096 };

/**
 * @return Number of rays for an engine: fewer for quad, which is a hundred times slower, and under
 *         sanitizers.
 */
static inline long ray_count_for(const Engine *engine, long count) {
    return (engine->mantissa_bits > 64 ? count / 100 : count) / WORKLOAD_DIVISOR;
}

/** @return A ray from one point towards another. */
static inline RayQueryQuad ray_towards(Vec3d from, Vec3d to) {
    return (RayQueryQuad){{from.x, from.y, from.z}, {to.x - from.x, to.y - from.y, to.z - from.z}};
}

/** A test of one engine. */
typedef void (*EngineTest)(const Engine *engine);

/** Runs a test in every engine that this machine supports. */
static inline void for_every_engine(EngineTest test) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if (engine_is_supported(*engine)) {
            test(*engine);
        }
    }
}

#endif
