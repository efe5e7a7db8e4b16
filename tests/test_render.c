/**
 * @file
 * @brief Pictures: the same bits whatever the threads, the lanes, the passes, the scale.
 */
#include "fixtures.h"
#include "pictures.h"

#include <glob.h>

/** 1, 2, 3 and 8 threads draw the same picture. @param state Not used. */
static void test_threads(void **state) {
    (void)state;
    Scene *scene = load("scenes/box.lua");
    RenderSettings settings = small_settings(scene, "auto", 1);
    settings.samples = 3;
    Picture one = draw(scene, &settings);
    for (int threads = 2; threads <= 8; threads += threads == 3 ? 5 : 1) {
        settings.threads = threads;
        assert_same(&one, draw(scene, &settings));
    }
    picture_release(&one);
    scene_destroy(scene);
}

/** Sixteen lanes, eight, four and one draw the same picture of every scene there is: of lists of
 *  shapes and of trees, of mirrors, glass, models, pictures and lamps.
 *  @param state Not used. */
static void test_lanes(void **state) {
    (void)state;
    glob_t scenes;
    assert_int_equal(glob("scenes/*.lua", 0, NULL, &scenes), 0);
    static const char *const engines[] = {"f32x1", "f32x4", "f32x8", "f32x16", "f64x1", "f64x4"};
    link_module("dioptre-meshes.so");
    link_module("dioptre-images.so");
    for (size_t s = 0; s < scenes.gl_pathc; s++) {
        Scene *scene = load(scenes.gl_pathv[s]);
        Picture narrow = {0};
        for (size_t e = 0; e < sizeof engines / sizeof *engines; e++) {
            Error error;
            if (!engine_find(engines[e], &error)) {
                continue;
            }
            RenderSettings settings = small_settings(scene, engines[e], 2);
            settings.samples = 3;
            settings.width = 83;
            settings.height = 61;
            if (strstr(engines[e], "x1") && !strstr(engines[e], "x16")) {
                picture_release(&narrow);
                narrow = draw(scene, &settings);
            } else {
                assert_same(&narrow, draw(scene, &settings));
            }
        }
        picture_release(&narrow);
        scene_destroy(scene);
    }
    globfree(&scenes);
}

/** @return A point moved away from the origin. @param v The point. @param factor How many times. */
static Vector3 grown(Vector3 v, double factor) {
    return vector3_scale(v, factor);
}

/** Makes a whole scene larger. Shape parameters hold nothing but lengths and points here.
 *  @param scene The scene. @param factor How many times. */
static void scale_scene(Scene *scene, double factor) {
    scene->camera.position = grown(scene->camera.position, factor);
    for (size_t i = 0; i < scene->light_count; i++) {
        Light *light = &scene->lights[i];
        light->position = grown(light->position, factor);
        light->intensity *= light->falloff == FALLOFF_INVERSE_SQUARE ? factor * factor : 1;
    }
    const Keyword *const *keywords = engine_list()[0]->shape_keywords;
    for (size_t i = 0; i < scene->shape_count; i++) {
        const Keyword *keyword = keywords[scene->shapes[i].kind];
        char *values = (char *)(uintptr_t)scene->shapes[i].parameters;
        for (const Parameter *row = keyword->parameters; row->name; row++) {
            double *numbers = (double *)(void *)(values + row->offset);
            int count = row->type == PARAMETER_NUMBER ? 1 : 3;
            for (int n = 0; n < count && strcmp(row->name, "normal") != 0; n++) {
                numbers[n] *= factor;
            }
        }
    }
}

/** A scene a power of two larger or smaller is bitwise the same picture: nothing in it is absolute.
 *  @param state Not used. */
static void test_scale(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/box.lua", "scenes/figure-09.lua"};
    for (size_t s = 0; s < 2; s++) {
        Scene *scene = load(scenes[s]);
        RenderSettings settings = small_settings(scene, "auto", 2);
        Picture picture = draw(scene, &settings);
        for (int power = -20; power <= 20; power += 10) {
            Scene *scaled = load(scenes[s]);
            scale_scene(scaled, ldexp(1, power));
            assert_same(&picture, draw(scaled, &settings));
            scene_destroy(scaled);
        }
        picture_release(&picture);
        scene_destroy(scene);
    }
}

/** What passes in the background end in is what is drawn at once, bit for bit; also after it was
 *  stopped half-way, and after the camera has gone away and come back. @param state Not used. */
static void test_background(void **state) {
    (void)state;
    Scene *scene = load("scenes/box.lua");
    RenderSettings settings = small_settings(scene, "auto", 2);
    settings.samples = 5;
    Picture at_once = draw(scene, &settings);
    Renderer *renderer = create(scene, &settings);
    int passes = 0;
    assert_same(&at_once, draw_in_background(renderer, scene, &passes));
    assert_true(passes >= 1);

    Camera home = scene->camera;
    camera_move(&scene->camera, 0.5, 0.25, 1);
    Picture moved = draw_in_background(renderer, scene, &passes);
    Comparison comparison = picture_compare(&at_once, &moved, NULL);
    assert_true(comparison.worst_step > 20);
    picture_release(&moved);
    for (int i = 0; i < 20; i++) {
        Error error;
        assert_true(renderer_start(renderer, scene, WIDTH, HEIGHT, NULL, NULL, &error));
    }
    scene->camera = home;
    assert_same(&at_once, draw_in_background(renderer, scene, &passes));
    renderer_destroy(renderer);
    picture_release(&at_once);
    scene_destroy(scene);
}

/** A drawing that is stopped says so and keeps what is finished. @param state Not used. */
static void test_stop(void **state) {
    (void)state;
    Scene *scene = load("scenes/box.lua");
    RenderSettings settings = small_settings(scene, "auto", 2);
    Renderer *renderer = create(scene, &settings);
    atomic_bool stop = true;
    RenderReport report = renderer_draw(renderer, &stop, NULL);
    assert_false(report.is_finished);
    assert_true(report.share < 1);
    renderer_destroy(renderer);
    scene_destroy(scene);
}

/** Pictures of one pixel, one row and one column. @param state Not used. */
static void test_small_sizes(void **state) {
    (void)state;
    static const int sizes[][2] = {{1, 1}, {1, 9}, {9, 1}, {8, 4}, {65, 17}};
    Scene *scene = load("scenes/box.lua");
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        RenderSettings settings = small_settings(scene, "f32x1", 1);
        settings.width = sizes[i][0];
        settings.height = sizes[i][1];
        Picture narrow = draw(scene, &settings);
        settings.engine = engine_find("auto", NULL);
        assert_same(&narrow, draw(scene, &settings));
        picture_release(&narrow);
    }
    scene_destroy(scene);
}

/** The camera's rays mirror each other, bit for bit: a scene that is the same on both sides gives a
 *  picture that is. @param state Not used. */
static void test_symmetry(void **state) {
    (void)state;
    Error error = {0};
    Scene *scene = empty_scene();
    SphereParameters ball = {{0, 0, -4}, 1};
    add_shape(scene, "sphere", &ball);
    Light light = *(const Light *)light_keyword.defaults;
    light.position = (Vector3){0, 3, 0};
    assert_true(scene_add_light(scene, &light, &error));
    RenderSettings settings = small_settings(scene, "auto", 1);
    Picture picture = draw(scene, &settings);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            const uint8_t *row = picture.pixels + 3 * y * WIDTH;
            assert_memory_equal(row + 3 * x, row + 3 * (WIDTH - 1 - x), 3);
        }
    }
    picture_release(&picture);
    scene_destroy(scene);
}

/** Facing mirrors: the n-th image is rho^n as bright (closed form). One sees a glowing wall behind
 *  itself in two mirrors; each order of it is a step darker. @param engine The engine. */
static void facing_mirrors(const Engine *engine) {
    const double share = 0.5;
    Error error = {0};
    Scene *scene = empty_scene();
    Material mirror = *(const Material *)material_keyword.defaults;
    mirror.reflectivity = (Color){share, share, share};
    mirror.color = (Color){0, 0, 0};
    mirror.emission = (Color){0.25, 0.25, 0.25};
    assert_true(scene_add_material(scene, &mirror, &error));
    PlaneParameters front = {{0, 0, -1}, {0, 0, 1}}, back = {{0, 0, 1}, {0, 0, 1}};
    add_shape(scene, "plane", &front);
    add_shape(scene, "plane", &back);
    for (int depth = 0; depth < 12; depth++) {
        double rgb[3];
        scene->image.depth = depth;
        RayCounts counts = trace_pixel(engine, scene, rgb);
        // 0.25 (1 + rho + ... + rho^depth); every term is exact in binary.
        double truth = 0.25 * (1 - pow(share, depth + 1)) / (1 - share);
        assert_at_most(fabs(rgb[0] - truth), 0, "depth %d in %s", depth, engine->name);
        assert_int_equal((int)counts.mirror, depth);
    }
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_facing_mirrors(void **state) {
    (void)state;
    in_every_engine(facing_mirrors);
}

/** @return A wall with two lamps at 45 degrees above the point that the camera looks at.
 *  @param away How far the wall is from the camera and from the lamps' feet. */
static Scene *wall_with_lamps(double away) {
    Error error = {0};
    Scene *scene = empty_scene();
    PlaneParameters wall = {{0, 0, -away}, {0, 0, 1}};
    add_shape(scene, "plane", &wall);
    for (int i = 0; i < 2; i++) {
        Light light = {.position = {i ? away : -away, 0, 0},
                       .color = {1, 0.5, 0.25},
                       .intensity = away * away,
                       .falloff = FALLOFF_INVERSE_SQUARE};
        assert_true(scene_add_light(scene, &light, &error));
    }
    return scene;
}

/** Point lights add, weaken with the square of the distance and with the cosine, to a few ulps of
 *  the closed form, from 1e-6 to 1e6 away (rows A3, A5, A6). @param engine The engine. */
static void irradiance(const Engine *engine) {
    for (double away = 1e-6; away <= 1e6; away *= 100) {
        double rgb[3];
        Scene *scene = wall_with_lamps(away);
        RayCounts counts = trace_pixel(engine, scene, rgb);
        // Two lamps at 45 degrees, sqrt(2) away: 2 * cos 45 / 2.
        double u = engine->mantissa_bits == 24 ? 0x1p-24 : 0x1p-52;
        for (int c = 0; c < 3; c++) {
            assert_at_most(fabs(rgb[c] - ldexp(sqrt(0.5), -c)), 16 * u, "light %g away in %s", away,
                           engine->name);
        }
        assert_int_equal((int)counts.shadow, 2);
        scene_destroy(scene);
    }
}

/** @param state Not used. */
static void test_irradiance(void **state) {
    (void)state;
    in_every_engine(irradiance);
}

/** No offset shows the black points of report C, the default shows none: a lit ball without
 *  neighbours, seen from its lamp, has no dark pixel. @param state Not used. */
static void test_acne(void **state) {
    (void)state;
    Error error = {0};
    Scene *scene = empty_scene();
    SphereParameters ball = {{0.3, 0.1, -40.7}, 3.3};
    add_shape(scene, "sphere", &ball);
    Light light = {.position = {0, 0, 0}, .color = {1, 1, 1}, .intensity = 1};
    assert_true(scene_add_light(scene, &light, &error));
    int dark[2] = {0, 0};
    for (int offset = OFFSET_NONE; offset <= OFFSET_BOUND; offset += OFFSET_BOUND) {
        RenderSettings settings = small_settings(scene, "auto", 1);
        settings.trace.offset = (OffsetStrategy)offset;
        Picture picture = draw(scene, &settings);
        // The middle of the picture is all ball, lit head-on.
        for (int y = HEIGHT / 2 - 8; y < HEIGHT / 2 + 8; y++) {
            for (int x = WIDTH / 2 - 8; x < WIDTH / 2 + 8; x++) {
                dark[offset / OFFSET_BOUND] += picture.pixels[3 * (y * WIDTH + x)] < 128;
            }
        }
        picture_release(&picture);
    }
    assert_true(dark[0] > 10);
    assert_int_equal(dark[1], 0);
    scene_destroy(scene);
}

/** @return A plane and many spheres. @param count How many. @param is_mirrored Whether they mirror.
 */
static Scene *crowd(size_t count, bool is_mirrored) {
    Scene *scene = empty_scene();
    const Color half = {0.5, 0.5, 0.5};
    uint64_t state = 7;
    scene->materials[scene->material_count - 1].reflectivity = is_mirrored ? half : (Color){0};
    add_shape(scene, "plane", &(PlaneParameters){{0, -2, 0}, {0, 1, 0}});
    for (size_t i = 0; i < count; i++) {
        double x = random_float(&state, -3, 3), y = random_float(&state, -2, 2);
        SphereParameters ball = {{x, y, random_float(&state, -9, -5)}, 0.3};
        add_shape(scene, "sphere", &ball);
    }
    return scene;
}

/** @return What the tracer of a scene is made of. @param scene The scene, given back here.
 *  @param depth How often rays are mirrored. */
static TracerContents contents_of(Scene *scene, int depth) {
    RenderSettings settings = small_settings(scene, "auto", 1);
    settings.trace.depth = depth;
    Renderer *renderer = create(scene, &settings);
    TracerContents contents = renderer_contents(renderer);
    renderer_destroy(renderer);
    scene_destroy(scene);
    return contents;
}

/** With a tree and without, the picture is the same, in every engine. @param engine The engine. */
static void tree_changes_nothing(const Engine *engine) {
    if (engine->mantissa_bits > 100) {
        return; // As the others of one lane, but slow.
    }
    Scene *scene = crowd(100, true);
    RenderSettings settings = small_settings(scene, engine->name, 2);
    settings.trace.tree = TREE_NEVER;
    Picture listed = draw(scene, &settings);
    settings.trace.tree = TREE_ALWAYS;
    assert_same(&listed, draw(scene, &settings));
    picture_release(&listed);
    scene_destroy(scene);
}

/** See #tree_changes_nothing. @param state Not used. */
static void test_tree(void **state) {
    (void)state;
    in_every_engine(tree_changes_nothing);
}

/** A scene gets a tree from as many shapes on as it says: from fewer where they mirror; shapes
 *  without an end do not count. @param state Not used. */
static void test_tree_pays(void **state) {
    (void)state;
    size_t matt = contents_of(crowd(1, false), 5).tree_from;
    size_t mirrored = contents_of(crowd(1, true), 5).tree_from;
    assert_true(8 < mirrored && mirrored < matt);
    assert_int_equal(contents_of(crowd(1, true), 0).tree_from, matt);
    for (int i = 0; i < 2; i++) {
        size_t from = i ? mirrored : matt;
        TracerContents few = contents_of(crowd(from - 1, i), 5),
                       many = contents_of(crowd(from, i), 5);
        assert_int_equal(few.planted, 0);
        assert_int_equal(few.listed, from);
        assert_int_equal(many.planted, from);
        assert_int_equal(many.listed, 1);
    }
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_threads),    cmocka_unit_test(test_lanes),
        cmocka_unit_test(test_scale),      cmocka_unit_test(test_background),
        cmocka_unit_test(test_stop),       cmocka_unit_test(test_small_sizes),
        cmocka_unit_test(test_symmetry),   cmocka_unit_test(test_facing_mirrors),
        cmocka_unit_test(test_irradiance), cmocka_unit_test(test_acne),
        cmocka_unit_test(test_tree),       cmocka_unit_test(test_tree_pays),
    };
    return cmocka_run_group_tests_name("render", tests, NULL, NULL);
}
