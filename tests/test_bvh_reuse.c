/**
 * @file
 * @brief The BVHs of a film's meshes are built once, not per frame.
 */
#include "bvh_queries.h"

/** A counter of the BVHs that are built on one thread. */
typedef struct BvhBuildCounter {
    int count; /**< Number of BVHs. */
} BvhBuildCounter;

/** Runs and counts the build of a BVH. See #ParallelFor.run. */
static void count_build(void *workers, size_t count, void (*job)(void *, size_t), void *context) {
    ((BvhBuildCounter *)workers)->count++;
    for (size_t i = 0; i < count; i++) {
        job(context, i);
    }
}

/** @return A mesh with (u, v) coordinates per vertex, to be destroyed. */
static Mesh *sphere_mesh_with_uvs(void) {
    Error error = {0};
    TriangleSoup t = icosphere_triangles(2);
    Mesh *mesh = mesh_create(&(Mesh){.position_count = t.position_count,
                                     .triangle_count = t.triangle_count,
                                     .uv_count = t.position_count},
                             &error);
    assert_non_null(mesh);
    memcpy(mesh->positions, t.positions, t.position_count * sizeof *t.positions);
    memcpy(mesh->triangles, t.triangles, t.triangle_count * sizeof *t.triangles);
    memcpy(mesh->triangle_uvs, t.triangles, t.triangle_count * sizeof *t.triangles);
    triangle_soup_destroy(&t);
    mesh_update_bounds(mesh);
    return mesh;
}

/** Adds an existing mesh to a scene, rotated. @param degrees Angle of rotation. */
static void add_turned_mesh(Scene *scene, Mesh *mesh, int normals, double degrees) {
    Error error = {0};
    char name[32];
    snprintf(name, sizeof name, "%zu", scene->mesh_count);
    SceneFile file = {.path = name, .name = name, .location = "test:1"};
    MeshShapeParameters row = {.normals = normals};
    Transform transform = {.scale = {1, 1, 1}, .rotate = {0, degrees, 0}};
    assert_true(scene_add_mesh(scene, &file, &row.file, &error));
    scene->meshes[row.file].mesh = mesh_retain(mesh);
    add_shape(scene, "mesh", &row);
    assert_true(transform_keyword.finish(&transform, 0, &error));
    assert_true(scene_set_last_transform(scene, &transform, &error));
}

/**
 * @return A scene with one mesh, to be destroyed.
 * @param degrees  Angle of rotation.
 */
static Scene *scene_with(Mesh *mesh, int normals, double degrees) {
    Scene *scene = create_empty_scene();
    add_turned_mesh(scene, mesh, normals, degrees);
    return scene;
}

/**
 * Creates the tracer of a scene and destroys the scene.
 * @param[out] trees  Number of BVHs built for it.
 * @return The tracer, to be destroyed.
 */
static Tracer *create_tracer_reusing(const Engine *engine, Scene *scene, const Tracer *reuse_from,
                                     int *trees) {
    Error error = {0};
    BvhBuildCounter builders = {0};
    TraceSettings settings = {.offset = OFFSET_BOUND,
                              .parallel_for = {&builders, 1, count_build},
                              .reuse_from = reuse_from};
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    assert_non_null(tracer);
    scene_destroy(scene);
    *trees = builders.count;
    return tracer;
}

/** Fails unless two tracers return the same bits. */
static void assert_same_tracers(const Engine *engine, const Tracer *got, const Tracer *wanted) {
    uint64_t state = 5;
    RayQueryQuad rays[RAYS_PER_QUERY];
    RayResult answers[RAYS_PER_QUERY], expected[RAYS_PER_QUERY];
    for (int i = 0; i < RAYS_PER_QUERY; i++) {
        rays[i] = ray_towards((Vec3d){0, 0, 9}, point_in_scene(&state));
    }
    engine->intersect(got, RAYS_PER_QUERY, rays, answers);
    engine->intersect(wanted, RAYS_PER_QUERY, rays, expected);
    assert_same_results(engine, "a shared tree", RAYS_PER_QUERY, answers, expected);
    assert_true(expected[0].shape == 0);
}

/** A rotated mesh keeps its BVH, and the BVH survives the frame it was built for. */
static void check_turned_reuse(const Engine *engine) {
    int first, second, alone;
    Mesh *mesh = sphere_mesh_with_uvs();
    Tracer *before = create_tracer_reusing(engine, scene_with(mesh, 1, 0), NULL, &first);
    Tracer *after = create_tracer_reusing(engine, scene_with(mesh, 1, 30), before, &second);
    Tracer *lonely = create_tracer_reusing(engine, scene_with(mesh, 1, 30), NULL, &alone);
    mesh_release(mesh);
    engine->destroy(before);
    assert_int_equal(first, 1);
    assert_int_equal(second, 0);
    assert_int_equal(alone, 1);
    assert_same_tracers(engine, after, lonely);
    engine->destroy(after);
    engine->destroy(lonely);
}

/**
 * A BVH is rebuilt for different normals and for another mesh, but not for the same meshes in
 * another order.
 */
static void check_different_meshes(const Engine *engine) {
    int trees;
    Mesh *one = sphere_mesh_with_uvs(), *two = sphere_mesh_with_uvs();
    Scene *both = scene_with(two, 1, 5);
    add_turned_mesh(both, one, 1, 5);
    Tracer *before = create_tracer_reusing(engine, scene_with(one, 1, 0), NULL, &trees);
    Tracer *flat = create_tracer_reusing(engine, scene_with(one, 2, 0), before, &trees);
    assert_int_equal(trees, 1);
    Tracer *other = create_tracer_reusing(engine, scene_with(two, 1, 0), before, &trees);
    assert_int_equal(trees, 1);
    Tracer *more = create_tracer_reusing(engine, both, before, &trees);
    assert_int_equal(trees, 1);
    Tracer *last = create_tracer_reusing(engine, scene_with(one, 1, 9), more, &trees);
    assert_int_equal(trees, 0);
    Tracer *const all[] = {before, flat, other, more, last};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        engine->destroy(all[i]);
    }
    mesh_release(one);
    mesh_release(two);
}

/**
 * A mesh that gets a texture needs (u, v) coordinates in its BVH. A mesh that loses its texture
 * keeps its BVH.
 */
static void check_textured_reuse(const Engine *engine) {
    int trees;
    Error error = {0};
    Mesh *mesh = sphere_mesh_with_uvs();
    Scene *scene = scene_with(mesh, 1, 0);
    SceneFile file = {.path = "a.png", .name = "a.png", .location = "test:1"};
    size_t index;
    assert_true(scene_add_texture(scene, &file, &index, &error));
    scene->textures[index].texture = texture_create(1, 1, false, &error);
    scene->materials[scene->shapes[0].material_index].texture_id = index + 1;
    Tracer *bare = create_tracer_reusing(engine, scene_with(mesh, 1, 0), NULL, &trees);
    Tracer *worn = create_tracer_reusing(engine, scene, bare, &trees);
    assert_int_equal(trees, 1);
    Tracer *again = create_tracer_reusing(engine, scene_with(mesh, 1, 0), worn, &trees);
    assert_int_equal(trees, 0);
    engine->destroy(bare);
    engine->destroy(worn);
    engine->destroy(again);
    mesh_release(mesh);
}

/** See #check_turned_reuse. */
static void test_turned(void **state) {
    (void)state;
    for_every_engine(check_turned_reuse);
}

/** See #check_different_meshes. */
static void test_others(void **state) {
    (void)state;
    for_every_engine(check_different_meshes);
}

/** See #check_textured_reuse. */
static void test_textured(void **state) {
    (void)state;
    for_every_engine(check_textured_reuse);
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_turned),
        cmocka_unit_test(test_others),
        cmocka_unit_test(test_textured),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
