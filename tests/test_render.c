/**
 * @file
 * @brief Pictures are bitwise equal for any threads, lanes, passes and scale.
 */
#include "fixtures.h"
#include "pictures.h"
#include "render/render_pass.h"

#include <glob.h>
#include <math.h>
#include <pthread.h>

/** 1, 2, 3 and 8 threads render the same picture. */
static void test_threads(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    RenderSettings settings = small_settings(scene, "auto", 1);
    settings.samples = 3;
    Picture one = draw_picture(scene, &settings);
    for (int threads = 2; threads <= 8; threads += threads == 3 ? 5 : 1) {
        settings.threads = threads;
        assert_same_picture(&one, draw_picture(scene, &settings));
    }
    picture_deinit(&one);
    scene_destroy(scene);
}

/**
 * Sixteen, eight, four lanes and one render the same picture of every scene: lists and BVHs,
 * mirrors, glass, meshes, textures and lights.
 */
static void test_lanes(void **state) {
    (void)state;
    glob_t scenes;
    assert_int_equal(glob("scenes/*.lua", 0, NULL, &scenes), 0);
    static const char *const engines[] = {"f32x1", "f32x4", "f32x8", "f32x16", "f64x1", "f64x4"};
    symlink_plugin("dioptre-meshes.so");
    symlink_plugin("dioptre-images.so");
    for (size_t s = 0; s < scenes.gl_pathc; s++) {
        Scene *scene = load_scene(scenes.gl_pathv[s]);
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
                picture_deinit(&narrow);
                narrow = draw_picture(scene, &settings);
            } else {
                assert_same_picture(&narrow, draw_picture(scene, &settings));
            }
        }
        picture_deinit(&narrow);
        scene_destroy(scene);
    }
    globfree(&scenes);
}

/** Puts a sphere where the corner of four tiles is seen, give or take two pixels. @param random The
 *  random state. */
static void add_sphere_at_tile_corner(Scene *scene, uint64_t *random) {
    const SceneCamera *camera = &scene->camera;
    double pixel = 2 * tan(camera->fov / 2 * (M_PI / 180)) / WIDTH;
    double column = TILE_COLUMNS * floor(4 * random_unit_double(random));
    double row = TILE_ROWS * floor(20 * random_unit_double(random));
    double x = pixel * (column - WIDTH / 2.0 + random_float(random, -2, 2));
    double y = pixel * (HEIGHT / 2.0 - row + random_float(random, -2, 2));
    double distance = exp(random_float(random, -2, 8));
    Vec3d direction = vec3d_add(camera->direction, vec3d_scale(scene_camera_right(camera), x));
    direction = vec3d_add(direction, vec3d_scale(camera->up, y));
    SphereParameters sphere = {vec3d_add(camera->position, vec3d_scale(direction, distance)),
                               distance * pixel * exp(random_float(random, -1, 3))};
    add_shape(scene, "sphere", &sphere);
}

/** Tiles that show nothing but a plain sky are filled without a ray; engines of one lane trace all
 *  of theirs. Small spheres at the edges of tiles, seen in all directions, are in both pictures. */
static void test_background_tiles(void **state) {
    (void)state;
    /** Number of scenes. */
    enum { SCENES = 60 };
    static const char *const engines[] = {"f32x4", "f32x8", "f32x16", "f64x4"};
    uint64_t random = 18;
    for (int s = 0; s < SCENES; s++) {
        Scene *scene = create_empty_scene();
        scene->sky = (SceneSky){.horizon = {0.5, 0.6, 0.7}, .zenith = {0.5, 0.6, 0.7}};
        scene->camera.position = (Vec3d){random_float(&random, -9, 9), 0, s};
        scene_camera_rotate(&scene->camera, (Vec3d){0, 1, 0}, 15.0 * s, 11.0 * (s % 16 - 8));
        for (int i = 0; i < 3; i++) {
            add_sphere_at_tile_corner(scene, &random);
        }
        for (size_t e = 0; e < sizeof engines / sizeof *engines; e++) {
            Error error;
            if (engine_find(engines[e], &error)) {
                RenderSettings settings = small_settings(scene, engines[e], 1);
                settings.samples = 2;
                Picture wide = draw_picture(scene, &settings);
                settings.engine = engine_scalar(settings.engine);
                assert_same_picture(&wide, draw_picture(scene, &settings));
                picture_deinit(&wide);
            }
        }
        scene_destroy(scene);
    }
}

/** @return A point, scaled about the origin. */
static Vec3d scaled_point(Vec3d v, double factor) {
    return vec3d_scale(v, factor);
}

/** Scales a whole scene. All shape parameters are lengths and points here. */
static void scale_scene(Scene *scene, double factor) {
    scene->camera.position = scaled_point(scene->camera.position, factor);
    for (size_t i = 0; i < scene->light_count; i++) {
        SceneLight *light = &scene->lights[i];
        light->position = scaled_point(light->position, factor);
        light->intensity *= light->falloff == FALLOFF_INVERSE_SQUARE ? factor * factor : 1;
    }
    for (size_t i = 0; i < scene->shape_count; i++) {
        const Keyword *keyword = scene_shape_keywords[scene->shapes[i].class_index];
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

/** A scene scaled by a power of two gives a bitwise equal picture: no constant is absolute. */
static void test_scale(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/box.lua", "scenes/figure-09.lua"};
    for (size_t s = 0; s < 2; s++) {
        Scene *scene = load_scene(scenes[s]);
        RenderSettings settings = small_settings(scene, "auto", 2);
        Picture picture = draw_picture(scene, &settings);
        for (int power = -20; power <= 20; power += 10) {
            Scene *larger = load_scene(scenes[s]);
            scale_scene(larger, ldexp(1, power));
            assert_same_picture(&picture, draw_picture(larger, &settings));
            scene_destroy(larger);
        }
        picture_deinit(&picture);
        scene_destroy(scene);
    }
}

/**
 * The passes in the background end in the picture of a single call, bit for bit; also after a stop,
 * and after the camera moved away and back.
 */
static void test_background(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    RenderSettings settings = small_settings(scene, "auto", 2);
    settings.samples = 5;
    Picture at_once = draw_picture(scene, &settings);
    Renderer *renderer = create_renderer(scene, &settings);
    int passes = 0;
    assert_same_picture(&at_once, draw_in_background(renderer, scene, &passes));
    assert_true(passes >= 1);

    SceneCamera home = scene->camera;
    scene_camera_move(&scene->camera, 0.5, 0.25, 1);
    Picture moved = draw_in_background(renderer, scene, &passes);
    PictureComparison comparison = picture_compare(&at_once, &moved, NULL);
    assert_true(comparison.max_difference > 20);
    picture_deinit(&moved);
    for (int i = 0; i < 20; i++) {
        Error error;
        assert_true(renderer_start(renderer, scene, WIDTH, HEIGHT, NULL, NULL, &error));
    }
    scene->camera = home;
    assert_same_picture(&at_once, draw_in_background(renderer, scene, &passes));
    renderer_destroy(renderer);
    picture_deinit(&at_once);
    scene_destroy(scene);
}

/** What is seen of a first pass that takes long. */
typedef struct PartWitness {
    pthread_mutex_t mutex; /**< Guards the rest. */
    pthread_cond_t wake;   /**< Signalled by the first event. */
    int events;            /**< Number of events. */
} PartWitness;

/** Counts an event. See #RenderPassCallback. */
static void count_event(void *context) {
    PartWitness *witness = context;
    pthread_mutex_lock(&witness->mutex);
    witness->events++;
    pthread_cond_signal(&witness->wake);
    pthread_mutex_unlock(&witness->mutex);
}

/** @return The rays of a forecast of a scene. */
static RayCounts forecast_of(const char *path, int width, int height) {
    Scene *scene = load_scene(path);
    RenderSettings settings = render_settings_default(scene);
    settings.width = width;
    settings.height = height;
    Renderer *renderer = create_renderer(scene, &settings);
    RayCounts rays = renderer_forecast_light(renderer, 100, NULL);
    renderer_destroy(renderer);
    scene_destroy(scene);
    return rays;
}

/** A forecast finds that light will be missing, also of small pictures, and in no simple one. */
static void test_forecast_of_light(void **state) {
    (void)state;
    RayCounts small = forecast_of("tests/scenes/half-mirrors.lua", 64, 48);
    assert_true(small.unresolved > 0 && small.unresolved_steps > 0.25);
    assert_true(small.camera >= 500 && small.camera <= 64 * 48);
    RayCounts large = forecast_of("scenes/box.lua", 803, 601);
    assert_true(large.unresolved == 0);
    assert_true(large.camera == 101 * 76);
    assert_true(forecast_of("scenes/figure-07.lua", 64, 48).camera == 0);
}

/** The first event of a scene whose first pass takes long comes before that pass has ended: some
 *  pixels are there, and others are not. */
static void test_first_pass_in_parts(void **state) {
    (void)state;
    Error error = {0};
    RenderStats stats;
    Scene *scene = load_scene("tests/scenes/half-mirrors.lua");
    RenderSettings settings = render_settings_default(scene);
    size_t pixels = (size_t)settings.width * (size_t)settings.height, shown = 0;
    uint8_t *bgrx = calloc(pixels, 4);
    assert_non_null(bgrx);
    PartWitness witness = {.mutex = PTHREAD_MUTEX_INITIALIZER, .wake = PTHREAD_COND_INITIALIZER};
    Renderer *renderer = create_renderer(scene, &settings);
    assert_true(renderer_pass_progress(renderer).fraction == 0);
    assert_true(renderer_start(renderer, scene, settings.width, settings.height, count_event,
                               &witness, &error));
    pthread_mutex_lock(&witness.mutex);
    while (witness.events == 0) {
        pthread_cond_wait(&witness.wake, &witness.mutex);
    }
    pthread_mutex_unlock(&witness.mutex);
    assert_true(renderer_copy_latest(renderer, &stats, bgrx, 4 * settings.width));
    renderer_stop(renderer);
    double fraction = renderer_pass_progress(renderer).fraction;
    assert_true(stats.is_part && !stats.is_finished);
    assert_true(fraction > 0 && fraction < 1);
    double shown_radius = 0, radius = 0;
    for (size_t i = 0; i < pixels; i++) {
        double x = (double)(i % (size_t)settings.width) - settings.width / 2.0;
        double y = (double)(i / (size_t)settings.width) - settings.height / 2.0;
        bool is_shown = bgrx[4 * i] > 0 || bgrx[4 * i + 1] > 0 || bgrx[4 * i + 2] > 0;
        shown += is_shown;
        radius += hypot(x, y) / (double)pixels;
        shown_radius += is_shown ? hypot(x, y) : 0;
    }
    assert_true(shown > 0 && shown < pixels);
    // The middle comes first.
    assert_true(shown_radius / (double)shown < 0.8 * radius);
    renderer_destroy(renderer);
    free(bgrx);
    scene_destroy(scene);
}

/** A stopped render reports that and keeps finished tiles. */
static void test_stop(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    RenderSettings settings = small_settings(scene, "auto", 2);
    Renderer *renderer = create_renderer(scene, &settings);
    atomic_bool stop = true;
    RenderStats report = renderer_render(renderer, &stop, NULL);
    assert_false(report.is_finished);
    assert_true(report.progress < 1);
    renderer_destroy(renderer);
    scene_destroy(scene);
}

/** Pictures of one pixel, one row and one column. */
static void test_small_sizes(void **state) {
    (void)state;
    static const int sizes[][2] = {{1, 1}, {1, 9}, {9, 1}, {8, 4}, {65, 17}};
    Scene *scene = load_scene("scenes/box.lua");
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        RenderSettings settings = small_settings(scene, "f32x1", 1);
        settings.width = sizes[i][0];
        settings.height = sizes[i][1];
        Picture narrow = draw_picture(scene, &settings);
        settings.engine = engine_find("auto", NULL);
        assert_same_picture(&narrow, draw_picture(scene, &settings));
        picture_deinit(&narrow);
    }
    scene_destroy(scene);
}

/** Camera rays are symmetric, bit for bit: a symmetric scene gives a symmetric picture. */
static void test_symmetry(void **state) {
    (void)state;
    Error error = {0};
    Scene *scene = create_empty_scene();
    SphereParameters sphere = {{0, 0, -4}, 1};
    add_shape(scene, "sphere", &sphere);
    SceneLight light = *(const SceneLight *)scene_light_keyword.defaults;
    light.position = (Vec3d){0, 3, 0};
    assert_true(scene_add_light(scene, &light, &error));
    RenderSettings settings = small_settings(scene, "auto", 1);
    Picture picture = draw_picture(scene, &settings);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            const uint8_t *row = picture.pixels + 3 * y * WIDTH;
            assert_memory_equal(row + 3 * x, row + 3 * (WIDTH - 1 - x), 3);
        }
    }
    picture_deinit(&picture);
    scene_destroy(scene);
}

/**
 * Two parallel mirrors: the n-th image has the brightness rho^n (closed form). The camera sees an
 * emissive wall behind it in two mirrors; each order adds a step.
 */
static void check_facing_mirrors(const Engine *engine) {
    const double share = 0.5;
    Error error = {0};
    Scene *scene = create_empty_scene();
    SceneMaterial mirror = *(const SceneMaterial *)scene_material_keyword.defaults;
    mirror.reflectivity = (Rgbd){share, share, share};
    mirror.color = (Rgbd){0, 0, 0};
    mirror.emission = (Rgbd){0.25, 0.25, 0.25};
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
        assert_int_equal((int)counts.reflection, depth);
    }
    scene_destroy(scene);
}

/** @param state Not used. */
static void test_facing_mirrors(void **state) {
    (void)state;
    for_every_engine(check_facing_mirrors);
}

/**
 * @return A wall with two lights at 45 degrees above the point that the camera views.
 * @param away  Distance of the wall from the camera, and of the lights from the wall.
 */
static Scene *wall_with_lights_scene(double away) {
    Error error = {0};
    Scene *scene = create_empty_scene();
    PlaneParameters wall = {{0, 0, -away}, {0, 0, 1}};
    add_shape(scene, "plane", &wall);
    for (int i = 0; i < 2; i++) {
        SceneLight light = {.position = {i ? away : -away, 0, 0},
                            .color = {1, 0.5, 0.25},
                            .intensity = away * away,
                            .falloff = FALLOFF_INVERSE_SQUARE};
        assert_true(scene_add_light(scene, &light, &error));
    }
    return scene;
}

/**
 * Irradiances of point lights add up. They follow the inverse square and the cosine to a few ulps
 * of the closed form, from 1e-6 to 1e6.
 */
static void check_irradiance(const Engine *engine) {
    for (double away = 1e-6; away <= 1e6; away *= 100) {
        double rgb[3];
        Scene *scene = wall_with_lights_scene(away);
        RayCounts counts = trace_pixel(engine, scene, rgb);
        // Two lights at 45 degrees and a distance of sqrt(2): 2 * cos 45 / 2.
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
    for_every_engine(check_irradiance);
}

/**
 * Without an offset there are the black points of report C, by default there are none: a lit sphere
 * alone, seen from its light, has no dark pixel.
 */
static void test_acne(void **state) {
    (void)state;
    Error error = {0};
    Scene *scene = create_empty_scene();
    SphereParameters sphere = {{0.3, 0.1, -40.7}, 3.3};
    add_shape(scene, "sphere", &sphere);
    SceneLight light = {.position = {0, 0, 0}, .color = {1, 1, 1}, .intensity = 1};
    assert_true(scene_add_light(scene, &light, &error));
    int dark[2] = {0, 0};
    for (int offset = OFFSET_NONE; offset <= OFFSET_BOUND; offset += OFFSET_BOUND) {
        RenderSettings settings = small_settings(scene, "auto", 1);
        settings.trace.offset = (OffsetStrategy)offset;
        Picture picture = draw_picture(scene, &settings);
        // The centre of the picture shows only the sphere, lit frontally.
        for (int y = HEIGHT / 2 - 8; y < HEIGHT / 2 + 8; y++) {
            for (int x = WIDTH / 2 - 8; x < WIDTH / 2 + 8; x++) {
                dark[offset / OFFSET_BOUND] += picture.pixels[3 * (y * WIDTH + x)] < 128;
            }
        }
        picture_deinit(&picture);
    }
    assert_true(dark[0] > 10);
    assert_int_equal(dark[1], 0);
    scene_destroy(scene);
}

/** @return A plane and many spheres. */
static Scene *many_spheres_scene(size_t count, bool is_mirror) {
    Scene *scene = create_empty_scene();
    const Rgbd half = {0.5, 0.5, 0.5};
    uint64_t state = 7;
    scene->materials[scene->material_count - 1].reflectivity = is_mirror ? half : (Rgbd){0};
    add_shape(scene, "plane", &(PlaneParameters){{0, -2, 0}, {0, 1, 0}});
    for (size_t i = 0; i < count; i++) {
        double x = random_float(&state, -3, 3), y = random_float(&state, -2, 2);
        SphereParameters sphere = {{x, y, random_float(&state, -9, -5)}, 0.3};
        add_shape(scene, "sphere", &sphere);
    }
    return scene;
}

/**
 * @return Statistics of the tracer of a scene.
 * @param scene  The scene, destroyed here.
 * @param depth  Recursion depth.
 */
static TracerStats scene_contents(Scene *scene, int depth) {
    RenderSettings settings = small_settings(scene, "auto", 1);
    settings.trace.depth = depth;
    Renderer *renderer = create_renderer(scene, &settings);
    TracerStats contents = renderer_contents(renderer);
    renderer_destroy(renderer);
    scene_destroy(scene);
    return contents;
}

/** The picture is equal with a BVH and without, in every engine. */
static void check_bvh_keeps_picture(const Engine *engine) {
    if (engine->mantissa_bits > 100) {
        return; // Equal to the others of one lane, but slow.
    }
    Scene *scene = many_spheres_scene(100, true);
    RenderSettings settings = small_settings(scene, engine->name, 2);
    settings.trace.bvh = BVH_NEVER;
    Picture listed = draw_picture(scene, &settings);
    settings.trace.bvh = BVH_ALWAYS;
    assert_same_picture(&listed, draw_picture(scene, &settings));
    picture_deinit(&listed);
    scene_destroy(scene);
}

/** See #check_bvh_keeps_picture. */
static void test_bvh(void **state) {
    (void)state;
    for_every_engine(check_bvh_keeps_picture);
}

/**
 * A scene gets a BVH from a minimum number of shapes, which is lower if they are reflective.
 * Unbounded shapes do not count.
 */
static void test_bvh_threshold(void **state) {
    (void)state;
    size_t matt = scene_contents(many_spheres_scene(1, false), 5).bvh_threshold;
    size_t mirrored = scene_contents(many_spheres_scene(1, true), 5).bvh_threshold;
    assert_true(8 < mirrored && mirrored < matt);
    assert_int_equal(scene_contents(many_spheres_scene(1, true), 0).bvh_threshold, matt);
    for (int i = 0; i < 2; i++) {
        size_t from = i ? mirrored : matt;
        TracerStats few = scene_contents(many_spheres_scene(from - 1, i), 5),
                    many = scene_contents(many_spheres_scene(from, i), 5);
        assert_int_equal(few.in_bvh, 0);
        assert_int_equal(few.linear, from);
        assert_int_equal(many.in_bvh, from);
        assert_int_equal(many.linear, 1);
    }
}

/** Runs the tests. @return 0 if all pass. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_threads),
        cmocka_unit_test(test_lanes),
        cmocka_unit_test(test_background_tiles),
        cmocka_unit_test(test_scale),
        cmocka_unit_test(test_background),
        cmocka_unit_test(test_first_pass_in_parts),
        cmocka_unit_test(test_forecast_of_light),
        cmocka_unit_test(test_stop),
        cmocka_unit_test(test_small_sizes),
        cmocka_unit_test(test_symmetry),
        cmocka_unit_test(test_facing_mirrors),
        cmocka_unit_test(test_irradiance),
        cmocka_unit_test(test_acne),
        cmocka_unit_test(test_bvh),
        cmocka_unit_test(test_bvh_threshold),
    };
    return cmocka_run_group_tests_name("render", tests, NULL, NULL);
}
