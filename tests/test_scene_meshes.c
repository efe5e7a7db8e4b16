/**
 * @file
 * @brief Tests of mesh files in scenes: their names, their folders, sharing, error locations.
 */
#include "fixtures.h"

#include "script/script_worker.h"

/** A triangle. */
#define TRIANGLE "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"

// --- a test shape, so that these tests do not depend on the tracer -------------------------------

/** A shape with a mesh. */
typedef struct TestStatue {
    size_t file;  /**< Index of the mesh file. */
    double scale; /**< A number. */
} TestStatue;

/** Fields of the shape. */
static const Parameter statue_parameters[] = {
    {.name = "file", .type = PARAMETER_MESH, .offset = offsetof(TestStatue, file)},
    {.name = "scale",
     .type = PARAMETER_NUMBER,
     .offset = offsetof(TestStatue, scale),
     .maximum = 9},
    {0}};

/** The default parameters. */
static const TestStatue statue_defaults = {.scale = 1};

/** Requires a file. See #Keyword.finish. @return false on error. */
static bool statue_finish(void *values, uint64_t given, Error *error) {
    (void)values;
    return (given & 1) || error_set(error, STATUS_SCENE, "statue needs a file");
}

/** The shape. */
static const Keyword statue_keyword = {.name = "statue",
                                       .parameters = statue_parameters,
                                       .size = sizeof(TestStatue),
                                       .defaults = &statue_defaults,
                                       .finish = statue_finish};
/** The shape classes of these tests. */
static const Keyword *const shapes[] = {&statue_keyword, NULL};

/** Runs the text of a scene in this program as a worker: no other program has the shape. */
static void run_test_scene(WorkerJob *job) {
    script_worker_scene(job, shapes);
}

// --- helpers -------------------------------------------------------------------------------------

/** Creates a folder with a scene's folder in it, and links the plugin. @return 0 on success. */
static int scene_mesh_set_up(void **state) {
    symlink_plugin("dioptre-meshes.so");
    return fixture_set_up(state) == 0 ? mkdir(fixture_path(state, "scene"), 0700) : -1;
}

/** Writes a file into the scene's folder. @return Its path. */
static const char *write_beside_scene(void **state, const char *name, const char *text) {
    char inside[PATH_MAX / 2];
    snprintf(inside, sizeof inside, "scene/%s", name);
    write_file(fixture_path(state, inside), text, strlen(text));
    return ((Fixture *)*state)->path;
}

/** Loads a scene. @return The scene, or NULL on failure. */
static Scene *load_scene(void **state, const char *text, const MeshProgress *progress,
                         Error *error) {
    const ScriptRequest request = {.path = write_beside_scene(state, "scene.lua", text),
                                   .time_limit = SCRIPT_TIME_LIMIT,
                                   .memory_limit = SCRIPT_MEMORY_LIMIT,
                                   .shape_keywords = shapes,
                                   .worker = "/proc/self/exe",
                                   .progress = progress};
    return script_load(&request, error);
}

/** @return A valid scene. */
static Scene *load_valid_scene(void **state, const char *text) {
    Error error = {0};
    Scene *scene = load_scene(state, text, NULL, &error);
    if (!scene) {
        fail_msg("%s", error.message);
    }
    return scene;
}

/** Asserts that a scene is refused. @param line Expected line of the error. */
static void assert_scene_refused(void **state, const char *text, int line, const char *words) {
    Error error = {0};
    char wanted[PATH_MAX + 256];
    Scene *scene = load_scene(state, text, NULL, &error);
    snprintf(wanted, sizeof wanted, "%s:%d: %s", fixture_path(state, "scene/scene.lua"), line,
             words);
    if (scene || error.status != STATUS_SCENE ||
        strncmp(error.message, wanted, strlen(wanted)) != 0) {
        fail_msg("wanted: %s\ngot: (%d) %s", wanted, error.status,
                 scene ? "a scene" : error.message);
    }
}

/** @return The parameters of a shape. */
static const TestStatue *statue_parameters_of(const Scene *scene, size_t i) {
    return scene->shapes[i].parameters;
}

// --- tests ---------------------------------------------------------------------------------------

/**
 * A mesh file is found beside the scene file, in a folder below it, and from an included file.
 * Different paths to the same file are read once.
 */
static void test_once(void **state) {
    mkdir(fixture_path(state, "scene/models"), 0700);
    write_beside_scene(state, "a.obj", TRIANGLE);
    write_beside_scene(state, "models/b.obj", TRIANGLE "f 3 2 1\n");
    assert_int_equal(symlink("a.obj", fixture_path(state, "scene/c.obj")), 0);
    write_beside_scene(state, "part.lua", "\nstatue { file = 'models/../a.obj' }");
    Scene *scene = load_valid_scene(state, "camera {}\nstatue { file = 'a.obj', scale = 2 }\n"
                                           "statue { file = 'models/b.obj' }\ninclude 'part.lua'\n"
                                           "statue { file = 'c.obj' }");
    char where[PATH_MAX + 16], real[PATH_MAX];
    snprintf(where, sizeof where, "%s:2", fixture_path(state, "scene/scene.lua"));
    assert_non_null(realpath(fixture_path(state, "scene/a.obj"), real));
    assert_int_equal(scene->mesh_count, 2);
    assert_string_equal(scene->meshes[0].file.location, where);
    assert_string_equal(scene->meshes[0].file.name, "a.obj");
    assert_string_equal(scene->meshes[0].file.path, real);
    assert_string_equal(scene->meshes[1].file.name, "models/b.obj");
    assert_int_equal(scene->meshes[0].mesh->triangle_count, 1);
    assert_int_equal(scene->meshes[1].mesh->triangle_count, 2);
    const size_t mesh_indices[] = {0, 1, 0, 0};
    for (size_t i = 0; i < 4; i++) {
        assert_int_equal(statue_parameters_of(scene, i)->file, mesh_indices[i]);
    }
    assert_true(statue_parameters_of(scene, 0)->scale == 2);
    scene_destroy(scene);
}

/** The number of meshes is not limited to a few. */
static void test_many(void **state) {
    for (int i = 1; i <= 40; i++) {
        char name[32];
        snprintf(name, sizeof name, "m%d.obj", i);
        write_beside_scene(state, name, TRIANGLE);
    }
    Scene *scene = load_valid_scene(state, "camera {}\nfor i = 1, 40 do\n"
                                           "  statue { file = 'm' .. i .. '.obj' }\nend");
    assert_int_equal(scene->mesh_count, 40);
    for (size_t i = 0; i < 40; i++) {
        assert_int_equal(statue_parameters_of(scene, i)->file, i);
        assert_int_equal(scene->meshes[i].mesh->triangle_count, 1);
    }
    scene_destroy(scene);
}

/** Invalid names of mesh files are refused at their line. */
static void test_refused_names(void **state) {
    char text[256];
    write_beside_scene(state, "../outside.obj", TRIANGLE);
    mkdir(fixture_path(state, "scene/folder.obj"), 0700);
    mkfifo(fixture_path(state, "scene/pipe.obj"), 0600);
    write_beside_scene(state, "model.txt", TRIANGLE);
    assert_int_equal(symlink("../outside.obj", fixture_path(state, "scene/link.obj")), 0);
    assert_int_equal(symlink("/dev/zero", fixture_path(state, "scene/zero.obj")), 0);
    const char *const names[][2] = {
        {"none.obj", "none.obj: No such file"},
        {"folder.obj", "folder.obj: this is a folder"},
        {"pipe.obj", "pipe.obj: this is a pipe"},
        {"model.txt", "model.txt: a model's name must end in .obj"},
        {"../outside.obj", "../outside.obj: No such file in the scene's folder"},
        {"link.obj", "link.obj: No such file in the scene's folder"},
        {"zero.obj", "zero.obj: No such file in the scene's folder"},
        {"/etc/passwd", "/etc/passwd: its name must say where it is from the scene file"},
        {"a\\0.obj", "file must not have a zero byte"},
        {"", "file must name a file"},
    };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        snprintf(text, sizeof text, "camera {}\n\nstatue { file = '%s' }", names[i][0]);
        assert_scene_refused(state, text, 3, names[i][1]);
    }
    assert_scene_refused(state, "camera {}\nstatue { file = 7 }", 2,
                         "file must be the name of a model");
    assert_scene_refused(state, "camera {}\nstatue {}", 2, "statue needs a file");
}

/** An error in a mesh file is reported at the line that names it first. */
static void test_refused_models(void **state) {
    write_beside_scene(state, "good.obj", TRIANGLE);
    write_beside_scene(state, "empty.obj", "v 0 0 0\nv 1 0 0\np 1\n");
    write_beside_scene(state, "escape.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 \033[31m3\n");
    assert_scene_refused(state,
                         "camera {}\nstatue { file = 'good.obj' }\nstatue { file = 'empty.obj' }\n"
                         "statue { file = 'empty.obj' }",
                         3, "empty.obj: there is no triangle in it");
    // Messages of a library cannot contain terminal control sequences.
    assert_scene_refused(state, "camera {}\nstatue { file = 'escape.obj' }", 2,
                         "escape.obj:4: `\\27[31m3` is no corner");
    Error error = {0};
    assert_null(load_scene(state, "camera {}\nstatue { file = 'escape.obj' }", NULL, &error));
    assert_null(strchr(error.message, '\033'));
}

/** Mesh files of a scene with an error are not read. */
static void test_scene_comes_first(void **state) {
    write_beside_scene(state, "empty.obj", "p 1\n");
    assert_scene_refused(state, "camera {}\nstatue { file = 'empty.obj' }\nerror('of mine')", 3,
                         "of mine");
}

/** Counts the calls. See MeshProgress::tell. */
static void count_progress(void *context, const char *name, double fraction, double seconds) {
    (void)name, (void)fraction, (void)seconds;
    ++*(int *)context;
}

/** Checks that reading has ended. See MeshProgress::end. @param context Number of calls so far. */
static void check_progress_end(void *context) {
    assert_true(*(int *)context > 0);
}

/** Progress is reported. */
static void test_progress(void **state) {
    int progress_count = 0;
    const MeshProgress progress = {
        .report = count_progress, .end = check_progress_end, .context = &progress_count};
    Error error = {0};
    write_beside_scene(state, "a.obj", TRIANGLE);
    Scene *scene = load_scene(state, "camera {}\nstatue { file = 'a.obj' }", &progress, &error);
    assert_non_null(scene);
    assert_true(progress_count > 0);
    scene_destroy(scene);
}

/** Runs the tests. @return Number of failed tests. */
int main(int argc, char **argv) {
    static const WorkerTask tasks[] = {{SCRIPT_SCENE_TASK, run_test_scene}, {0}};
    if (worker_is_requested(argc, argv)) {
        worker_main(argv, tasks);
    }
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_once, scene_mesh_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_many, scene_mesh_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_refused_names, scene_mesh_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_refused_models, scene_mesh_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_scene_comes_first, scene_mesh_set_up,
                                        fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_progress, scene_mesh_set_up, fixture_tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
