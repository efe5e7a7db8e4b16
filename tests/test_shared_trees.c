/**
 * @file
 * @brief The trees over the triangles of a film's meshes are built once, and not for each frame.
 */
#include "tree_questions.h"

/** Somebody who builds trees alone and counts them. */
typedef struct Builders {
    int trees; /**< Trees so far. */
} Builders;

/** Builds a tree. See #Crew.run. @param workers A #Builders. @param count See there. @param job See
 *  there. @param context See there. */
static void build(void *workers, size_t count, void (*job)(void *, size_t), void *context) {
    ((Builders *)workers)->trees++;
    for (size_t i = 0; i < count; i++) {
        job(context, i);
    }
}

/** @return A mesh with a place on a picture for each corner, to be given back. */
static Mesh *ball(void) {
    Error error = {0};
    Triangles t = icosphere(2);
    Mesh *mesh = mesh_create(&(Mesh){.position_count = t.position_count,
                                     .triangle_count = t.triangle_count,
                                     .uv_count = t.position_count},
                             &error);
    assert_non_null(mesh);
    memcpy(mesh->positions, t.positions, t.position_count * sizeof *t.positions);
    memcpy(mesh->triangles, t.triangles, t.triangle_count * sizeof *t.triangles);
    memcpy(mesh->triangle_uvs, t.triangles, t.triangle_count * sizeof *t.triangles);
    triangles_release(&t);
    return mesh;
}

/** Adds a mesh that is there already to a scene, turned. @param scene The scene. @param mesh The
 *  mesh. @param normals See #MeshRow. @param degrees How far it is turned. */
static void show(Scene *scene, Mesh *mesh, int normals, double degrees) {
    Error error = {0};
    char name[32];
    snprintf(name, sizeof name, "%zu", scene->mesh_count);
    SceneFile file = {.path = name, .name = name, .where = "test:1"};
    MeshRow row = {.normals = normals};
    Transform transform = {.scale = {1, 1, 1}, .rotate = {0, degrees, 0}};
    assert_true(scene_add_mesh(scene, &file, &row.file, &error));
    scene->meshes[row.file].mesh = mesh_share(mesh);
    add_shape(scene, "mesh", &row);
    assert_true(transform_keyword.finish(&transform, 0, &error));
    assert_true(scene_transform_shape(scene, &transform, &error));
}

/** @return A scene with one mesh, to be given back. @param mesh The mesh. @param normals See
 *  #MeshRow. @param degrees How far it is turned. */
static Scene *scene_with(Mesh *mesh, int normals, double degrees) {
    Scene *scene = empty_scene();
    show(scene, mesh, normals, degrees);
    return scene;
}

/** Prepares a scene and gives it back. @param engine The engine. @param scene The scene.
 *  @param former See #TraceSettings.former. @param[out] trees How many trees were built for it.
 *  @return The tracer, to be given back. */
static Tracer *prepare_after(const Engine *engine, Scene *scene, const Tracer *former, int *trees) {
    Error error = {0};
    Builders builders = {0};
    TraceSettings settings = {
        .offset = OFFSET_BOUND, .crew = {&builders, 1, build}, .former = former};
    Tracer *tracer = engine->prepare(scene, &settings, &error);
    assert_non_null(tracer);
    scene_destroy(scene);
    *trees = builders.trees;
    return tracer;
}

/** Fails unless two tracers answer the same, to the bit. @param engine The engine. @param got One.
 *  @param wanted The other. */
static void assert_alike(const Engine *engine, const Tracer *got, const Tracer *wanted) {
    uint64_t state = 5;
    RayQuery rays[TOGETHER];
    RayAnswer answers[TOGETHER], expected[TOGETHER];
    for (int i = 0; i < TOGETHER; i++) {
        rays[i] = ray_towards((Vector3){0, 0, 9}, point_in_scene(&state));
    }
    engine->intersect(got, TOGETHER, rays, answers);
    engine->intersect(wanted, TOGETHER, rays, expected);
    assert_same(engine, "a shared tree", TOGETHER, answers, expected);
    assert_true(expected[0].shape == 0);
}

/** A mesh that is turned keeps its tree, and its tree outlives the frame that it was built for.
 *  @param engine The engine. */
static void turned(const Engine *engine) {
    int first, second, alone;
    Mesh *mesh = ball();
    Tracer *before = prepare_after(engine, scene_with(mesh, 1, 0), NULL, &first);
    Tracer *after = prepare_after(engine, scene_with(mesh, 1, 30), before, &second);
    Tracer *lonely = prepare_after(engine, scene_with(mesh, 1, 30), NULL, &alone);
    mesh_destroy(mesh);
    engine->release(before);
    assert_int_equal(first, 1);
    assert_int_equal(second, 0);
    assert_int_equal(alone, 1);
    assert_alike(engine, after, lonely);
    engine->release(after);
    engine->release(lonely);
}

/** What differs is built anew: other normals, another mesh; but not the same in another order.
 *  @param engine The engine. */
static void others(const Engine *engine) {
    int trees;
    Mesh *one = ball(), *two = ball();
    Scene *both = scene_with(two, 1, 5);
    show(both, one, 1, 5);
    Tracer *before = prepare_after(engine, scene_with(one, 1, 0), NULL, &trees);
    Tracer *flat = prepare_after(engine, scene_with(one, 2, 0), before, &trees);
    assert_int_equal(trees, 1);
    Tracer *other = prepare_after(engine, scene_with(two, 1, 0), before, &trees);
    assert_int_equal(trees, 1);
    Tracer *more = prepare_after(engine, both, before, &trees);
    assert_int_equal(trees, 1);
    Tracer *last = prepare_after(engine, scene_with(one, 1, 9), more, &trees);
    assert_int_equal(trees, 0);
    Tracer *const all[] = {before, flat, other, more, last};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        engine->release(all[i]);
    }
    mesh_destroy(one);
    mesh_destroy(two);
}

/** A mesh that begins to wear a picture needs its places there; a mesh that wore one has what a
 * bare one needs. @param engine The engine. */
static void dressed(const Engine *engine) {
    int trees;
    Error error = {0};
    Mesh *mesh = ball();
    Scene *scene = scene_with(mesh, 1, 0);
    SceneFile file = {.path = "a.png", .name = "a.png", .where = "test:1"};
    size_t place;
    assert_true(scene_add_texture(scene, &file, &place, &error));
    scene->textures[place].texture = texture_create(1, 1, false, &error);
    scene->materials[scene->shapes[0].material].texture = place + 1;
    Tracer *bare = prepare_after(engine, scene_with(mesh, 1, 0), NULL, &trees);
    Tracer *worn = prepare_after(engine, scene, bare, &trees);
    assert_int_equal(trees, 1);
    Tracer *again = prepare_after(engine, scene_with(mesh, 1, 0), worn, &trees);
    assert_int_equal(trees, 0);
    engine->release(bare);
    engine->release(worn);
    engine->release(again);
    mesh_destroy(mesh);
}

/** See #turned. @param state Not used. */
static void test_turned(void **state) {
    (void)state;
    in_every_engine(turned);
}

/** See #others. @param state Not used. */
static void test_others(void **state) {
    (void)state;
    in_every_engine(others);
}

/** See #dressed. @param state Not used. */
static void test_dressed(void **state) {
    (void)state;
    in_every_engine(dressed);
}

/** Runs the tests. @return How many failed. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_turned),
        cmocka_unit_test(test_others),
        cmocka_unit_test(test_dressed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
