/**
 * @file
 * @brief What scenes need: path hashes tell edges from errors, estimates choose the right number
 * type, and results on a sample of pixels hold for all of them.
 */
#include "testing.h"

#include "dioptre/renderer.h"
#include "dioptre/script.h"
#include "lab/needs/image_difference.h"
#include "lab/needs/needs.h"

#include <stdlib.h>

/** Size of the pictures. */
enum { WIDTH = 96, HEIGHT = 72 };

/** @return A scene from its file. */
static Scene *load_scene(const char *path) {
    Error error = {0};
    ScriptRequest request = {
        .path = path, .time_limit = SCRIPT_TIME_LIMIT, .memory_limit = SCRIPT_MEMORY_LIMIT};
    Scene *scene = script_load(&request, &error);
    if (!scene) {
        fail_msg("%s", error.message);
    }
    return scene;
}

/**
 * Renders all pixels of a small picture of a scene.
 * @param offset  How rays leave surfaces.
 * @return The rays.
 */
static SampledRender render_all_pixels(const Scene *scene, const char *engine,
                                       OffsetStrategy offset, const PixelSet *pixels) {
    SampledRender render;
    Error error = {0};
    RenderSettings settings = render_settings_default(scene);
    Variant variant = {
        .engine = engine_find(engine, &error), .trace = settings.trace, .samples_traced = 1};
    RenderContext render_context = {scene, pixels, 1, NULL};
    variant.trace.samples = 1;
    variant.trace.offset = offset;
    assert_non_null(variant.engine);
    assert_true(render_samples(&render_context, &variant, &render, &error));
    return render;
}

/* --- path hashes ------------------------------------------------------------------------------ */

/** Path hashes are the same at every width; double and float differ only at edges. */
static void test_path_hashes_agree(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/box.lua", "scenes/glass-sphere.lua",
                                         "scenes/orbits.lua", "scenes/lamps.lua"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        Scene *scene = load_scene(scenes[i]);
        PixelSet pixels;
        assert_true(pixel_set_init(&pixels, WIDTH, HEIGHT, pixel_is_any, NULL, NULL));
        SampledRender one = render_all_pixels(scene, "f32x1", OFFSET_BOUND, &pixels);
        SampledRender four = render_all_pixels(scene, "f32x4", OFFSET_BOUND, &pixels);
        SampledRender exact = render_all_pixels(scene, "f64x1", OFFSET_BOUND, &pixels);
        assert_memory_equal(one.path_hashes, four.path_hashes,
                            one.ray_count * sizeof *one.path_hashes);
        assert_memory_equal(one.rgb, four.rgb, 3 * one.ray_count * sizeof *one.rgb);
        ImageDifference difference = image_difference_of(&one, &exact, &exact, ENCODING_SRGB);
        assert_at_most(difference.rays - difference.same_path, 2e-3 * (double)difference.rays, "%s",
                       scenes[i]);
        assert_at_most(difference.visible, 1e-3 * (double)difference.rays, "%s", scenes[i]);
        sampled_render_deinit(&one);
        sampled_render_deinit(&four);
        sampled_render_deinit(&exact);
        pixel_set_deinit(&pixels);
        scene_destroy(scene);
    }
}

/**
 * Path hashes of selected pixels equal those of the whole picture. They differ for different
 * shapes, faces and shadows.
 */
static void test_path_hashes_differ(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    PixelSet all, some;
    assert_true(pixel_set_init(&all, WIDTH, HEIGHT, pixel_is_any, NULL, NULL));
    assert_true(pixel_set_init(&some, WIDTH, HEIGHT, pixel_is_sampled, NULL, NULL));
    assert_int_equal((int)some.count, WIDTH * HEIGHT / 64);
    SampledRender whole = render_all_pixels(scene, "f32x4", OFFSET_BOUND, &all);
    SampledRender part = render_all_pixels(scene, "f32x1", OFFSET_BOUND, &some);
    size_t kinds = 0;
    for (size_t i = 1; i < whole.ray_count; i++) {
        kinds += whole.path_hashes[i] != whole.path_hashes[i - 1];
    }
    assert_true(kinds > 200 && kinds < whole.ray_count / 2);
    size_t found = 0;
    for (size_t i = 0; i < part.ray_count; i++) {
        for (size_t k = 0; k < whole.ray_count; k++) {
            if (whole.path_hashes[k] == part.path_hashes[i]) {
                found++;
                break;
            }
        }
    }
    assert_int_equal((int)found, (int)part.ray_count);
    sampled_render_deinit(&whole);
    sampled_render_deinit(&part);
    pixel_set_deinit(&all);
    pixel_set_deinit(&some);
    scene_destroy(scene);
}

/** Black pixels are outliers: no edge is near them. Edge flips of float are no outliers. */
static void test_outliers_are_no_edges(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    PixelSet pixels;
    Error error = {0};
    assert_true(pixel_set_init(&pixels, WIDTH, HEIGHT, pixel_is_any, NULL, NULL));
    RenderSettings settings = render_settings_default(scene);
    RenderContext render_context = {scene, &pixels, 1, NULL};
    Variant reference = {
        .engine = engine_find("f64x1", NULL), .trace = settings.trace, .samples_traced = 1};
    reference.trace.samples = 1;
    SampledRender truth = render_all_pixels(scene, "f64x1", OFFSET_BOUND, &pixels);
    SampledRender good = render_all_pixels(scene, "f32x1", OFFSET_BOUND, &pixels);
    SampledRender acne = render_all_pixels(scene, "f32x1", OFFSET_NONE, &pixels);
    size_t outliers = 1;
    assert_true(outliers_count(&render_context, &reference, &truth, &good, &outliers, &error));
    assert_int_equal((int)outliers, 0);
    assert_true(outliers_count(&render_context, &reference, &truth, &acne, &outliers, &error));
    assert_true(outliers > 100);
    sampled_render_deinit(&truth);
    sampled_render_deinit(&good);
    sampled_render_deinit(&acne);
    pixel_set_deinit(&pixels);
    scene_destroy(scene);
}

/* --- precision estimates ---------------------------------------------------------------------- */

/** A scene, and its expected estimate. */
typedef struct ExpectedForecast {
    const char *path;     /**< Its file. */
    bool is_float;        /**< Whether float is sufficient. */
    PrecisionCause cause; /**< If not: the cause. */
} ExpectedForecast;

/** Scenes of all kinds, and some on which simpler estimates fail. */
static const ExpectedForecast expected[] = {
    {"scenes/box.lua", true, 0},
    {"scenes/facing-mirrors.lua", true, 0},
    {"scenes/glass-of-water.lua", true, 0},
    {"scenes/hundred-thousand-spheres.lua", true, 0},
    {"scenes/twins.lua", true, 0},
    {"scenes/endless-frames.lua", true, 0},
    {"scenes/cow.lua", true, 0},
    {"scenes/figure-12.lua", true, 0},
    {"scenes/figure-16.lua", false, PRECISION_SHADOW_TERMINATOR},
    {"scenes/teapot.lua", false, PRECISION_SHADOW_TERMINATOR},
    {"tests/scenes/tiny-lamp.lua", true, 0},
    {"scenes/mandelbulb.lua", false, PRECISION_FRACTAL},
    {"tests/scenes/far-small-sphere.lua", false, PRECISION_DISTANCE},
    {"tests/scenes/far-from-zero.lua", true, 0},
    {"tests/scenes/ground-sphere.lua", false, PRECISION_POSITION},
    {"tests/scenes/deep-mirrors.lua", false, PRECISION_RAY_DIVERGENCE},
    {"tests/scenes/thin-shells.lua", false, PRECISION_THIN_GLASS}};

/** The precision estimate chooses the engine. */
static void test_forecasts(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        Scene *scene = load_scene(expected[i].path);
        PrecisionEstimate forecast = precision_estimate_of(scene);
        const Engine *engine = precision_estimate_engine(&forecast);
        if ((engine->mantissa_bits == 24) != expected[i].is_float) {
            fail_msg("%s: %s, forecast %g", expected[i].path, engine->name,
                     precision_estimate_error(&forecast));
        }
        assert_true(expected[i].is_float || forecast.cause == expected[i].cause);
        assert_ptr_equal(render_settings_default(scene).engine, engine);
        scene_destroy(scene);
    }
}

/** The depth is that of the script, or else none is set where anything reflects. */
static void test_depths(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/orbits.lua");
    assert_int_equal(render_settings_default(scene).trace.depth, 3);
    scene->image.depth = IMAGE_DEPTH_AUTO;
    // As deep as the weight of a ray asks for.
    assert_int_equal(render_settings_default(scene).trace.depth, DEPTH_MAXIMUM);
    for (size_t i = 0; i < scene->material_count; i++) {
        scene->materials[i].reflectivity = (Rgbd){0, 0, 0};
    }
    assert_int_equal(render_settings_default(scene).trace.depth, 0);
    scene->materials[scene->shapes[0].material_index].reflectivity = (Rgbd){1, 1, 1};
    assert_int_equal(render_settings_default(scene).trace.depth, DEPTH_MAXIMUM);
    scene_destroy(scene);
}

/* --- needs ------------------------------------------------------------------------------------ */

/**
 * @return What a scene needs.
 * @param is_whole  Whether all pixels are rendered.
 */
static Needs needs_of(const Scene *scene, bool is_whole) {
    Needs needs;
    Error error = {0};
    RenderSettings settings = render_settings_default(scene);
    NeedsRequest request = {.width = 2 * WIDTH,
                            .height = 2 * HEIGHT,
                            .samples = 2,
                            .depth = scene->image.depth,
                            .trace = &settings.trace,
                            .threads = 2,
                            .uses_all_pixels = is_whole};
    if (!needs_find(scene, &request, &needs, &error)) {
        fail_msg("%s", error.message);
    }
    return needs;
}

/** Results on a sample hold for whole pictures. */
static void test_sparse_pixels_suffice(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/box.lua",
                                         "scenes/figure-08.lua",
                                         "scenes/facing-mirrors.lua",
                                         "scenes/twins.lua",
                                         "tests/scenes/far-from-zero.lua",
                                         "scenes/lamps.lua",
                                         "tests/scenes/ground-sphere.lua"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        Scene *scene = load_scene(scenes[i]);
        Needs sampled_needs = needs_of(scene, false), whole = needs_of(scene, true);
        bool is_float = sampled_needs.engines[sampled_needs.engine].engine->mantissa_bits == 24;
        bool is_forecast = precision_estimate_engine(&sampled_needs.forecast)->mantissa_bits == 24;
        assert_true(is_float == is_forecast);
        assert_int_equal(sampled_needs.engine, whole.engine);
        double fraction = (double)(whole.total_trial.visible + whole.total_trial.outliers) /
                          (double)whole.total_trial.rays;
        assert_at_most(fraction, 4e-4, "%s: share off", scenes[i]);
        char words[2048];
        needs_explain(&sampled_needs, words, sizeof words);
        assert_non_null(strstr(words, is_float ? "Float is enough" : "Double is enough"));
        scene_destroy(scene);
    }
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_path_hashes_agree),
                                       cmocka_unit_test(test_path_hashes_differ),
                                       cmocka_unit_test(test_outliers_are_no_edges),
                                       cmocka_unit_test(test_forecasts),
                                       cmocka_unit_test(test_depths),
                                       cmocka_unit_test(test_sparse_pixels_suffice)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
