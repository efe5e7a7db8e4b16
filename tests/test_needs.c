/**
 * @file
 * @brief Forecasts and pilots: trails tell edges from errors, forecasts choose the right number
 *        type, and what a sample of pixels promises is true of all of them.
 */
#include "testing.h"

#include "dioptre/needs.h"
#include "dioptre/renderer.h"
#include "dioptre/script.h"
#include "lab/strays.h"

#include <stdlib.h>

/** Pixels of the pictures that are tried. */
enum { WIDTH = 96, HEIGHT = 72 };

/** @return A scene from its file. @param path The file. */
static Scene *load(const char *path) {
    Error error = {0};
    ScriptRequest request = {.path = path,
                             .seconds = SCRIPT_SECONDS,
                             .memory = SCRIPT_MEMORY,
                             .shape_keywords = engine_find("f32x1", NULL)->shape_keywords};
    Scene *scene = script_load(&request, &error);
    if (!scene) {
        fail_msg("%s", error.message);
    }
    return scene;
}

/** Shoots all pixels of a small picture of a scene. @param scene The scene. @param engine The
 *  engine. @param offset How rays leave surfaces. @param pixels The pixels. @return The shot. */
static Shot shoot(const Scene *scene, const char *engine, OffsetStrategy offset,
                  const Pixels *pixels) {
    Shot shot;
    Error error = {0};
    RenderSettings settings = render_settings_default(scene);
    Manner manner = {.engine = engine_find(engine, &error), .trace = settings.trace, .rays = 1};
    Studio studio = {scene, pixels, 1, NULL};
    manner.trace.samples = 1;
    manner.trace.offset = offset;
    assert_non_null(manner.engine);
    assert_true(shot_take(&studio, &manner, &shot, &error));
    return shot;
}

/* --- trails ----------------------------------------------------------------------------------- */

/** Trails are the same at every width; in double they differ from float only at edges.
 *  @param state The fixture. */
static void test_trails_are_the_same(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/box.lua", "scenes/glass-sphere.lua",
                                         "scenes/orbits.lua", "scenes/lamps.lua"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        Scene *scene = load(scenes[i]);
        Pixels pixels;
        assert_true(pixels_make(&pixels, WIDTH, HEIGHT, pixel_is_any, NULL, NULL));
        Shot one = shoot(scene, "f32x1", OFFSET_BOUND, &pixels);
        Shot four = shoot(scene, "f32x4", OFFSET_BOUND, &pixels);
        Shot exact = shoot(scene, "f64x1", OFFSET_BOUND, &pixels);
        assert_memory_equal(one.trails, four.trails, one.count * sizeof *one.trails);
        assert_memory_equal(one.rgb, four.rgb, 3 * one.count * sizeof *one.rgb);
        Contrast contrast = contrast_of(&one, &exact, &exact, ENCODING_SRGB);
        assert_at_most(contrast.rays - contrast.equal, 2e-3 * (double)contrast.rays, "%s",
                       scenes[i]);
        assert_at_most(contrast.off, 1e-3 * (double)contrast.rays, "%s", scenes[i]);
        shot_release(&one);
        shot_release(&four);
        shot_release(&exact);
        pixels_release(&pixels);
        scene_destroy(scene);
    }
}

/** Trails of chosen pixels are those of the whole picture, and shapes, faces and shadows have
 *  different ones. @param state The fixture. */
static void test_trails_tell_things_apart(void **state) {
    (void)state;
    Scene *scene = load("scenes/box.lua");
    Pixels all, some;
    assert_true(pixels_make(&all, WIDTH, HEIGHT, pixel_is_any, NULL, NULL));
    assert_true(pixels_make(&some, WIDTH, HEIGHT, pixel_is_sampled, NULL, NULL));
    assert_int_equal((int)some.count, WIDTH * HEIGHT / 64);
    Shot whole = shoot(scene, "f32x4", OFFSET_BOUND, &all);
    Shot part = shoot(scene, "f32x1", OFFSET_BOUND, &some);
    size_t kinds = 0;
    for (size_t i = 1; i < whole.count; i++) {
        kinds += whole.trails[i] != whole.trails[i - 1];
    }
    assert_true(kinds > 200 && kinds < whole.count / 2);
    size_t found = 0;
    for (size_t i = 0; i < part.count; i++) {
        for (size_t k = 0; k < whole.count; k++) {
            if (whole.trails[k] == part.trails[i]) {
                found++;
                break;
            }
        }
    }
    assert_int_equal((int)found, (int)part.count);
    shot_release(&whole);
    shot_release(&part);
    pixels_release(&all);
    pixels_release(&some);
    scene_destroy(scene);
}

/** Black points are strays: no edge is near them. Float's flips are not. @param state The fixture.
 */
static void test_strays_are_no_edges(void **state) {
    (void)state;
    Scene *scene = load("scenes/box.lua");
    Pixels pixels;
    Error error = {0};
    assert_true(pixels_make(&pixels, WIDTH, HEIGHT, pixel_is_any, NULL, NULL));
    RenderSettings settings = render_settings_default(scene);
    Studio studio = {scene, &pixels, 1, NULL};
    Manner reference = {.engine = engine_find("f64x1", NULL), .trace = settings.trace, .rays = 1};
    reference.trace.samples = 1;
    Shot truth = shoot(scene, "f64x1", OFFSET_BOUND, &pixels);
    Shot good = shoot(scene, "f32x1", OFFSET_BOUND, &pixels);
    Shot acne = shoot(scene, "f32x1", OFFSET_NONE, &pixels);
    size_t strays = 1;
    assert_true(strays_count(&studio, &reference, &truth, &good, &strays, &error));
    assert_int_equal((int)strays, 0);
    assert_true(strays_count(&studio, &reference, &truth, &acne, &strays, &error));
    assert_true(strays > 100);
    shot_release(&truth);
    shot_release(&good);
    shot_release(&acne);
    pixels_release(&pixels);
    scene_destroy(scene);
}

/* --- forecasts -------------------------------------------------------------------------------- */

/** A scene, and what is to be forecast. */
typedef struct Expected {
    const char *path;    /**< Its file. */
    bool is_float;       /**< Whether float is enough. */
    ForecastCause cause; /**< If not: why. */
} Expected;

/** Scenes of all kinds, and some that are built to fool the forecast. */
static const Expected expected[] = {{"scenes/box.lua", true, 0},
                                    {"scenes/facing-mirrors.lua", true, 0},
                                    {"scenes/glass-of-water.lua", true, 0},
                                    {"scenes/hundred-thousand-spheres.lua", true, 0},
                                    {"scenes/twins.lua", true, 0},
                                    {"scenes/endless-frames.lua", true, 0},
                                    {"scenes/cow.lua", true, 0},
                                    {"scenes/figure-12.lua", true, 0},
                                    {"scenes/figure-16.lua", false, FORECAST_FACETS},
                                    {"scenes/teapot.lua", false, FORECAST_FACETS},
                                    {"tests/scenes/tiny-lamp.lua", true, 0},
                                    {"scenes/mandelbulb.lua", false, FORECAST_FRACTAL},
                                    {"tests/scenes/far-small-sphere.lua", false, FORECAST_DISTANCE},
                                    {"tests/scenes/far-from-zero.lua", true, 0},
                                    {"tests/scenes/ground-sphere.lua", false, FORECAST_PLACE},
                                    {"tests/scenes/deep-mirrors.lua", false, FORECAST_TURNS},
                                    {"tests/scenes/thin-shells.lua", false, FORECAST_WALL}};

/** The engine is chosen by the scene's numbers. @param state The fixture. */
static void test_forecasts(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        Scene *scene = load(expected[i].path);
        Forecast forecast = forecast_of(scene);
        const Engine *engine = forecast_engine(&forecast);
        if ((engine->mantissa_bits == 24) != expected[i].is_float) {
            fail_msg("%s: %s, forecast %g", expected[i].path, engine->name,
                     forecast_steps(&forecast));
        }
        assert_true(expected[i].is_float || forecast.cause == expected[i].cause);
        assert_ptr_equal(render_settings_default(scene).engine, engine);
        scene_destroy(scene);
    }
}

/** Depth is the script's where it says one, else what the largest share asks for.
 *  @param state The fixture. */
static void test_depths(void **state) {
    (void)state;
    Scene *scene = load("scenes/orbits.lua");
    assert_int_equal(render_settings_default(scene).trace.depth, 3);
    scene->image.depth = IMAGE_DEPTH_NEEDED;
    // 0.35^9 is below 1.5e-4, 0.35^8 is not.
    assert_int_equal(render_settings_default(scene).trace.depth, 9);
    for (size_t i = 0; i < scene->material_count; i++) {
        scene->materials[i].reflectivity = (Color){0, 0, 0};
    }
    assert_int_equal(render_settings_default(scene).trace.depth, 0);
    scene->materials[scene->shapes[0].material].reflectivity = (Color){1, 1, 1};
    assert_int_equal(render_settings_default(scene).trace.depth, 64);
    scene_destroy(scene);
}

/* --- needs ------------------------------------------------------------------------------------ */

/** @return What a scene needs. @param scene The scene. @param is_whole Whether all pixels are
 *  tried. */
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
                            .is_whole = is_whole};
    if (!needs_find(scene, &request, &needs, &error)) {
        fail_msg("%s", error.message);
    }
    return needs;
}

/** What a pilot finds holds for whole pictures. @param state The fixture. */
static void test_pilots_hold(void **state) {
    (void)state;
    static const char *const scenes[] = {"scenes/box.lua",
                                         "scenes/figure-08.lua",
                                         "scenes/facing-mirrors.lua",
                                         "scenes/twins.lua",
                                         "tests/scenes/far-from-zero.lua",
                                         "scenes/lamps.lua",
                                         "tests/scenes/ground-sphere.lua"};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        Scene *scene = load(scenes[i]);
        Needs pilot = needs_of(scene, false), whole = needs_of(scene, true);
        bool is_float = pilot.engines[pilot.engine].engine->mantissa_bits == 24;
        bool is_forecast = forecast_engine(&pilot.forecast)->mantissa_bits == 24;
        assert_true(is_float == is_forecast);
        assert_int_equal(pilot.engine, whole.engine);
        double share = (double)(whole.total.off + whole.total.strays) / (double)whole.total.rays;
        assert_at_most(share, 4e-4, "%s: share off", scenes[i]);
        char words[2048];
        needs_explain(&pilot, words, sizeof words);
        assert_non_null(strstr(words, is_float ? "Float is enough" : "Double is enough"));
        scene_destroy(scene);
    }
}

/** Runs all tests. @return How many failed. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_trails_are_the_same),
                                       cmocka_unit_test(test_trails_tell_things_apart),
                                       cmocka_unit_test(test_strays_are_no_edges),
                                       cmocka_unit_test(test_forecasts),
                                       cmocka_unit_test(test_depths),
                                       cmocka_unit_test(test_pilots_hold)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
