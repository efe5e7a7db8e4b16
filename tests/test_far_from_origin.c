/**
 * @file
 * @brief Scenes far from the origin: pictures and hits equal those of the same scene at the origin,
 *        in every engine.
 *
 * The coordinates of the far scenes include the distance, as in a scene written by hand.
 */
#include "assets/images/image_file.h"
#include "fixtures.h"
#include "pictures.h"

#include <math.h>

/**
 * Distances of the scenes from the origin along each axis: 100, 10,000 and 1,000,000 times their
 * size. They are integers, so that mesh files hold them exactly.
 */
static const double distances[] = {1e3, 1e5, 1e7};

/**
 * A scene about 10 units large. It contains every kind of shape, transforms, combined distance
 * fields, a mesh twice, a texture, glass, mirrors and all kinds of lights.
 */
static const char scene_text[] =
    "local W = %.0f\n"
    "local function p(x, y, z) return {x + W, y - W, z + W} end\n"
    "camera { position = p(0.4, 2.6, 8), look_at = p(0, 0.9, 0), fov = 46 }\n"
    "image { width = 96, height = 72, depth = 6 }\n"
    "ambient(0.2)\n"
    "sun { direction = {-1, -2, -1}, intensity = 0.4 }\n"
    "light { position = p(-4, 6, 5), intensity = 0.4 }\n"
    "light { position = p(2.5, 2.6, 1), radius = 0.25, intensity = 2, falloff = 'inverse_square' "
    "}\n"
    "sky { horizon = {0.7, 0.8, 0.9}, zenith = {0.2, 0.4, 0.8} }\n"
    "local function m(r, g, b) return material { color = {r, g, b}, specular = 0.3 } end\n"
    "local worn = material { texture = 'worn.bmp' }\n"
    "local glass = material { transparency = 0.9, color = 0.02, ior = 1.5 }\n"
    "plane { point = p(0, 0, 0), material = worn }\n"
    "sphere { center = p(-1, 0.6, 1.5), radius = 0.6, material = glass }\n"
    "sphere { scale = {0.3, 0.5, 0.3}, rotate = {0, 0, 30}, translate = p(0.6, 0.6, 2.4), material "
    "= worn }\n"
    "quad { corner = p(-4, 0.1, -3), u = {8, 0, 0}, v = {0, 3, 0}, "
    "  material = material { color = 0.1, reflectivity = 0.8 } }\n"
    "box { min = p(1.2, 0, 1.2), max = p(1.9, 0.7, 1.9), material = m(0.7, 0.3, 0.2) }\n"
    "disk { center = p(-2.6, 1.9, -1), normal = {0.3, 0.2, 1}, radius = 0.5, material = worn }\n"
    "cylinder { base = p(-3, 0, 0), top = p(-3.1, 1.2, 0.2), radius = 0.4, material = m(0.2, 0.3, "
    "0.8) }\n"
    "triangle { a = p(2.2, 0.1, -1), b = p(3.6, 0.4, -1.4), c = p(2.6, 2, -1.6), material = worn "
    "}\n"
    "mesh { file = 'far.obj', material = m(0.3, 0.7, 0.3) }\n"
    "mesh { file = 'near.obj', rotate = {0, 30, 0}, translate = p(3.2, 0, 1), material = m(0.8, "
    "0.7, 0.1) }\n"
    "mesh { file = 'near.obj', rotate = {0, 10, 0}, translate = p(-2.2, 0, 2.6), material = m(0.2, "
    "0.7, 0.6) }\n"
    "local ball, die = distance.sphere { radius = 0.4 }, distance.box { size = {0.6, 0.6, 0.6} }\n"
    "sdf { distance.smooth_union(ball:translate(p(0, 0.5, 0)), die:round(0.05):translate(p(0.5, "
    "0.7, 0)), 0.3),\n"
    "  material = m(0.8, 0.2, 0.2) }\n"
    "sdf { distance.difference(die:translate(p(1.3, 0.4, -0.4)), ball:scale(0.9):translate(p(1.3, "
    "0.6, -0.2))),\n"
    "  material = m(0.8, 0.6, 0.2) }\n"
    "sdf { distance.intersection(die:rotate{0, 40, 0}:translate(p(-1.3, 0.4, -0.6)), "
    "ball:translate(p(-1.3, 0.4, -0.6))),\n"
    "  material = m(0.4, 0.2, 0.8) }\n"
    "sdf { distance.union(distance.torus { major = 0.4, minor = 0.1 }:translate(p(0, 1.7, -1)),\n"
    "  ball:scale(0.3):repeat_every{0.5, 0, 0, count = {3, 1, 1}}:translate(p(0, 2.3, -1))), "
    "material = "
    "m(0.2, 0.8, 0.8) }\n"
    "sdf { ball, translate = p(0.2, 0.3, 3), material = m(0.6, 0.6, 0.6) }\n";

/** A pyramid of four triangles on a square, from one corner. */
static const char mesh_text[] = "v %.0f %.0f %.0f\nv %.0f %.0f %.0f\nv %.0f %.0f %.0f\n"
                                "v %.0f %.0f %.0f\nf 1 2 3\nf 1 3 4\nf 1 4 2\nf 2 4 3\n";

/** Writes a mesh file. */
static void write_mesh_file(const char *path, double x, double y, double z) {
    char text[512];
    int size =
        snprintf(text, sizeof text, mesh_text, x, y, z, x + 1, y, z, x, y + 1, z, x, y, z - 1);
    write_file(path, text, (size_t)size);
}

/**
 * Writes the scene with its files, and loads it.
 * @return The scene.
 * @param distance  Distance from the origin along each axis.
 */
static Scene *scene_at_offset(void **state, double distance) {
    Error error = {0};
    char text[sizeof scene_text + 64];
    Picture worn = make_test_picture(5, 4);
    assert_true(image_file_write(fixture_path(state, "worn.bmp"), &worn, &error));
    picture_deinit(&worn);
    write_mesh_file(fixture_path(state, "near.obj"), 0, 0, 0);
    write_mesh_file(fixture_path(state, "far.obj"), distance + 1, -distance + 1, distance - 2);
    int size = snprintf(text, sizeof text, scene_text, distance);
    write_file(fixture_path(state, "far.lua"), text, (size_t)size);
    return load_scene(fixture_path(state, "far.lua"));
}

/** @return Largest difference of two pixels, in 8-bit steps. */
static int steps_between(const uint8_t *a, const uint8_t *b) {
    int largest = 0;
    for (int i = 0; i < 3; i++) {
        largest = abs(a[i] - b[i]) > largest ? abs(a[i] - b[i]) : largest;
    }
    return largest;
}

/** @return Whether an edge passes near a pixel: whether a neighbour has a different colour. */
static bool is_on_edge(const Picture *picture, int x, int y) {
    const uint8_t *here = picture->pixels + 3 * (y * picture->width + x);
    bool is_edge = false;
    for (int index = 0; index < 9; index++) {
        int column = x + index % 3 - 1, row = y + index / 3 - 1;
        if (column >= 0 && row >= 0 && column < picture->width && row < picture->height) {
            const uint8_t *neighbor = picture->pixels + 3 * (row * picture->width + column);
            is_edge = is_edge || steps_between(here, neighbor) > 8;
        }
    }
    return is_edge;
}

/**
 * Compares two pictures.
 * @param[out] elsewhere  Number of pixels that differ by more than a step and are not on an edge.
 * @return Number of pixels that differ by more than a step.
 */
static int count_different_pixels(const Picture *near, const Picture *far, int *elsewhere) {
    int different = 0;
    *elsewhere = 0;
    for (int i = 0; i < near->width * near->height; i++) {
        if (steps_between(near->pixels + 3 * i, far->pixels + 3 * i) > 1) {
            different++;
            *elsewhere += !is_on_edge(near, i % near->width, i / near->width);
        }
    }
    return different;
}

/** Pictures are equal except where a ray passes an edge within the rounding error. */
static void test_pictures(void **state) {
    static const char *const engines[] = {"f32x1", "f32x4", "f32x8", "f32x16", "f64x1", "f64x4"};
    for (size_t e = 0; e < sizeof engines / sizeof *engines; e++) {
        Error error = {0};
        const Engine *engine = engine_find(engines[e], &error);
        if (!engine) {
            continue;
        }
        Scene *scene = scene_at_offset(state, 0);
        RenderSettings settings = small_settings(scene, engines[e], 2);
        settings.width = 192;
        settings.height = 144;
        Picture near = draw_picture(scene, &settings);
        scene_destroy(scene);
        for (size_t i = 0; i < sizeof distances / sizeof *distances; i++) {
            scene = scene_at_offset(state, distances[i]);
            Picture far = draw_picture(scene, &settings);
            int elsewhere, different = count_different_pixels(&near, &far, &elsewhere);
            printf(
                "%-7s %8g from zero: %d pixels of %d are off by more than a step, %d on no edge\n",
                engines[e], distances[i], different, settings.width * settings.height, elsewhere);
            assert_at_most(elsewhere, 0, "%s, %g from zero: pixels on no edge", engines[e],
                           distances[i]);
            assert_at_most(different, settings.width * settings.height / 1000,
                           "%s, %g from zero: pixels", engines[e], distances[i]);
            picture_deinit(&far);
            scene_destroy(scene);
        }
        picture_deinit(&near);
    }
}

/**
 * Rays hit the same shape at the same place in a scene and in its far copy.
 * @param distance  Distance of the copy.
 */
static void compare_answers(const Engine *engine, const Scene *near, const Scene *far,
                            double distance) {
    static RayQueryQuad rays[2][BATCH];
    static RayResult answers[2][BATCH];
    const double way[3] = {distance, -distance, distance};
    uint64_t state = 7;
    int count = engine->mantissa_bits > 64 ? 64 : BATCH, apart = 0, met = 0;
    for (int i = 0; i < count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            double from = floor(1024 * (16 * random_unit_double(&state) - 8)) / 1024;
            double to = floor(1024 * (6 * random_unit_double(&state) - (axis == 1 ? 0 : 3))) / 1024;
            rays[0][i].origin[axis] = from;
            rays[1][i].origin[axis] = from + way[axis];
            rays[0][i].direction[axis] = rays[1][i].direction[axis] = to - from;
        }
    }
    const Scene *const scenes[] = {near, far};
    for (int s = 0; s < 2; s++) {
        Tracer *tracer = create_tracer(engine, scenes[s]);
        engine->intersect(tracer, (size_t)count, rays[s], answers[s]);
        engine->destroy(tracer);
    }
    for (int i = 0; i < count; i++) {
        const RayResult *a = &answers[0][i], *b = &answers[1][i];
        met += a->shape >= 0;
        if (a->shape != b->shape || a->occluded != b->occluded) {
            apart++;
            continue;
        }
        for (int axis = 0; axis < 3 && a->shape >= 0; axis++) {
            // A grazing ray magnifies an error along the surface. The far scene itself is rounded
            // to double.
            Quadruple difference = quad_abs(b->point[axis] - (Quadruple)way[axis] - a->point[axis]);
            Quadruple mark = 64 * a->error + 4096 * roundoff(engine) + 64 * 0x1p-53 * distance;
            assert_at_most(difference, mark, "%s, %g from zero, shape %d", engine->name, distance,
                           a->shape);
        }
    }
    assert_true(met > count / 2);
    assert_at_most(apart, count / 500, "%s, %g from zero: rays that meet something else",
                   engine->name, distance);
}

/** @param state The folder. */
static void test_answers(void **state) {
    Scene *near = scene_at_offset(state, 0);
    for (size_t i = 0; i < sizeof distances / sizeof *distances; i++) {
        Scene *far = scene_at_offset(state, distances[i]);
        for (const Engine *const *engine = engine_list(); *engine; engine++) {
            if (engine_is_supported(*engine)) {
                compare_answers(*engine, near, far, distances[i]);
            }
        }
        scene_destroy(far);
    }
    scene_destroy(near);
}

/** The bounding box of all shapes is in scene coordinates. */
static void test_bounds(void **state) {
    const Engine *engine = engine_list()[0];
    Scene *near = scene_at_offset(state, 0), *far = scene_at_offset(state, 1e5);
    Tracer *tracers[2] = {create_tracer(engine, near), create_tracer(engine, far)};
    Vec3d low[2], high[2];
    for (int i = 0; i < 2; i++) {
        engine->bounds(tracers[i], &low[i], &high[i]);
        engine->destroy(tracers[i]);
    }
    Vec3d direction = {1e5, -1e5, 1e5};
    Vec3d difference = vec3d_subtract(vec3d_subtract(low[1], direction), low[0]);
    assert_at_most(vec3d_max_abs(difference), 1e-4, "lowest corner");
    difference = vec3d_subtract(vec3d_subtract(high[1], direction), high[0]);
    assert_at_most(vec3d_max_abs(difference), 1e-4, "highest corner");
    scene_destroy(near);
    scene_destroy(far);
}

/**
 * A copy of a scene that was translated there and back gives the same picture, and shares what it
 * does not own.
 */
static void test_moved(void **state) {
    Error error = {0};
    Scene *scene = scene_at_offset(state, 0);
    RenderSettings settings = small_settings(scene, "auto", 2);
    Picture picture = draw_picture(scene, &settings);
    Scene *there = scene_translated(scene, (Vec3d){1024, -512, 2048}, &error);
    assert_non_null(there);
    Scene *back = scene_translated(there, (Vec3d){-1024, 512, -2048}, &error);
    assert_non_null(back);
    Picture again = draw_picture(back, &settings);
    int elsewhere, different = count_different_pixels(&picture, &again, &elsewhere);
    assert_int_equal(elsewhere, 0);
    assert_at_most(different, settings.width * settings.height / 1000, "pixels");
    picture_deinit(&picture);
    picture_deinit(&again);
    scene_destroy(back);
    scene_destroy(there);
    scene_destroy(scene);
}

/** @return 0 if all tests pass. */
int main(void) {
    symlink_plugin("dioptre-meshes.so");
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_pictures),
                                       cmocka_unit_test(test_answers),
                                       cmocka_unit_test(test_bounds), cmocka_unit_test(test_moved)};
    return cmocka_run_group_tests_name("origin", tests, fixture_set_up, fixture_tear_down);
}
