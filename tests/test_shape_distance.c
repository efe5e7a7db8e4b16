/**
 * @file
 * @brief Tests of the distance of a point from a shape: a lower bound, by which lamps with a
 * falloff are judged. A lamp within a model must not count as on its surface.
 */
#include "fixtures.h"

#include "load_scene.h"

/** A cube from -1 to 1. */
static const char CUBE[] = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
                           "v -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n"
                           "f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n";

/** A point and its distance from a shape. */
typedef struct DistanceCase {
    const char *shape; /**< The shape, as text. */
    Vec3d point;       /**< The point. */
    double distance;   /**< Its distance, which the bound may not exceed. */
    double least;      /**< What the bound is at least. */
} DistanceCase;

/** The bound is never above the distance, and near it where that is cheap. */
static void test_bounds(void **state) {
    static const DistanceCase cases[] = {
        {"sphere {}", {0, 0, 3}, 2, 2},
        {"sphere {}", {0, 0, 0.5}, 0.5, 0.5},
        {"sphere { scale = {2, 2, 2}, translate = {1, 0, 0} }", {1, 0, 0.5}, 1.5, 1.5},
        {"quad { corner = {0, 0, 0}, u = {1, 0, 0}, v = {0, 1, 0} }", {0.5, 0.5, 2}, 2, 2},
        {"quad { corner = {0, 0, 0}, u = {1, 0, 0}, v = {0, 1, 0} }", {4, 0, 0}, 3, 3},
        {"mesh { file = 'cube.obj' }", {0, 0, 0}, 1, 1},
        {"mesh { file = 'cube.obj' }", {0.75, 0.5, 0}, 0.25, 0.25},
        {"mesh { file = 'cube.obj' }", {1, 0.25, 0.25}, 0, 0},
        {"mesh { file = 'cube.obj' }", {4, 0, 0}, 3, 3},
        {"mesh { file = 'cube.obj' }", {4, 5, 0}, 5, 5},
        {"mesh { file = 'cube.obj', scale = {2, 1, 1}, translate = {5, 0, 0} }", {5, 0, 0}, 1, 1},
        {"mesh { file = 'cube.obj', scale = {2, 1, 1}, translate = {5, 0, 0} }", {9, 0, 0}, 2, 1},
    };
    write_file(fixture_path(state, "cube.obj"), CUBE, strlen(CUBE));
    for (size_t i = 0; i < COUNT(cases); i++) {
        char text[256];
        snprintf(text, sizeof text, "camera {}\n%s\n", cases[i].shape);
        const char *path = fixture_path(state, "scene.lua");
        write_file(path, text, strlen(text));
        Scene *scene = load_scene(path);
        double bound = scene_shape_distance(scene, &scene->shapes[0], cases[i].point);
        assert_at_most(bound, cases[i].distance * (1 + 1e-12), "%s %zu", cases[i].shape, i);
        assert_at_most(cases[i].least * (1 - 1e-12), bound, "least of %s %zu", cases[i].shape, i);
        scene_destroy(scene);
    }
}

/** A lamp in the middle of a hollow model, in a room, lights it as far away as it is. */
static void test_lamp_in_a_model(void **state) {
    static const char text[] =
        "camera {}\n"
        "light { position = {0, 0, 0}, intensity = 1, falloff = 'inverse_square' }\n"
        "mesh { file = 'cube.obj', material = material { color = {1, 1, 1} } }\n";
    write_file(fixture_path(state, "cube.obj"), CUBE, strlen(CUBE));
    const char *path = fixture_path(state, "scene.lua");
    write_file(path, text, strlen(text));
    Scene *scene = load_scene(path);
    double bound = scene_radiance_bound(scene, (const double[]){1, 1});
    // Diffuse and specular light of intensity 1 at distance 1, and the sky.
    assert_at_most(bound, 3, "the brightest light");
    assert_true(bound > 0.5);
    scene_destroy(scene);
}

/** @return 0 if all tests pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_bounds, fixture_set_up, fixture_tear_down),
        cmocka_unit_test_setup_teardown(test_lamp_in_a_model, fixture_set_up, fixture_tear_down),
    };
    return cmocka_run_group_tests_name("distance of shapes", tests, NULL, NULL);
}
