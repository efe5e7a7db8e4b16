/**
 * @file
 * @brief What scenes need: path hashes tell edges from errors, estimates choose the right number
 * type, and no whole picture refutes what is proposed.
 */
#include "load_scene.h"
#include "testing.h"

#include "base/pareto_front.h"
#include "dioptre/renderer.h"
#include "dioptre/script.h"
#include "lab/needs/image_difference.h"
#include "lab/needs/needs.h"

#include <stdlib.h>

/** Size of the pictures. */
enum { WIDTH = 96, HEIGHT = 72 };

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

/** Small pictures are sampled more densely: a few pixels would meet no edge and no black point. */
static void test_sampling_cells(void **state) {
    (void)state;
    assert_int_equal(sampling_cell_of(1920, 1080), SAMPLING_CELL_MAXIMUM);
    assert_int_equal(sampling_cell_of(320, 240), SAMPLING_CELL_MAXIMUM);
    assert_int_equal(sampling_cell_of(160, 120), SAMPLING_CELL_MAXIMUM / 2);
    assert_int_equal(sampling_cell_of(16, 12), 1);
    const int cell = 1;
    PixelSet all;
    assert_true(pixel_set_init(&all, 16, 12, pixel_is_sampled, &cell, NULL));
    assert_int_equal((int)all.count, 16 * 12);
    pixel_set_deinit(&all);
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
    const int cell = SAMPLING_CELL_MAXIMUM;
    assert_true(pixel_set_init(&some, WIDTH, HEIGHT, pixel_is_sampled, &cell, NULL));
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

/** @return A request for a picture. */
static NeedsRequest request_of(const Scene *scene, const RenderSettings *settings, int samples) {
    return (NeedsRequest){.width = WIDTH,
                          .height = HEIGHT,
                          .samples = samples,
                          .depth = scene->image.depth,
                          .trace = &settings->trace,
                          .threads = 2,
                          .error_steps = NEEDS_ERROR_STEPS};
}

/** @return What a request finds. */
static Needs find_needs(const Scene *scene, const NeedsRequest *request) {
    Needs needs;
    Error error = {0};
    if (!needs_find(scene, request, &needs, &error)) {
        fail_msg("%s", error.message);
    }
    return needs;
}

/** @return What a scene needs, with the default error. */
static Needs needs_of(const Scene *scene, int samples) {
    RenderSettings settings = render_settings_default(scene);
    NeedsRequest request = request_of(scene, &settings, samples);
    return find_needs(scene, &request);
}

/** Renders a picture as `dioptre render` does. @param width Pixels; the height follows. */
static Picture render_picture(const Scene *scene, const NeedsSettings *settings, int width) {
    RenderSettings render = render_settings_default(scene);
    Error error = {0};
    Picture picture;
    render.engine = settings->engine;
    render.width = width;
    render.height = width * HEIGHT / WIDTH;
    render.samples = settings->samples;
    render.sampling = SAMPLING_FULL;
    render.trace.depth = settings->depth;
    render.trace.cutoff = settings->cutoff;
    render.trace.offset = settings->offset;
    assert_true(picture_init(&picture, render.width, render.height, &error));
    Renderer *renderer = renderer_create(scene, &render, &error);
    assert_non_null(renderer);
    renderer_render(renderer, NULL, &picture);
    renderer_destroy(renderer);
    return picture;
}

/** Compares a proposal with everything on, by the codes of whole pictures. @return The fraction of
 *  the pixels that are off by more than a code. */
static double fraction_off(const Scene *scene, const Needs *needs, int width) {
    /** Finer than any that the search takes for the picture that it compares with. */
    const double finest_cutoff = 1e-4;
    NeedsSettings truth = {.engine = engine_with_role(ENGINE_DOUBLE),
                           .depth = DEPTH_MAXIMUM,
                           .cutoff = finest_cutoff,
                           .offset = OFFSET_BOUND,
                           .samples = needs->settings.samples};
    Picture best = render_picture(scene, &truth, width),
            mine = render_picture(scene, &needs->settings, width);
    PictureComparison comparison = picture_compare(&best, &mine, NULL);
    picture_deinit(&best);
    picture_deinit(&mine);
    return comparison.differing_fraction;
}

/** A scene whose proposal a whole picture is to confirm. */
typedef struct ExpectedNeeds {
    const char *path; /**< Its file. */
    bool is_float;    /**< Whether float is sufficient. */
    int width;        /**< Of the picture, pixels. */
} ExpectedNeeds;

/** No whole picture refutes a proposal, unless it says so. */
static void test_no_picture_refutes(void **state) {
    (void)state;
    static const ExpectedNeeds scenes[] = {{"scenes/box.lua", true, WIDTH},
                                           {"scenes/figure-08.lua", true, WIDTH},
                                           {"scenes/lamps.lua", true, WIDTH},
                                           {"scenes/figure-18.lua", true, WIDTH},
                                           {"tests/scenes/tiny-lamp.lua", true, WIDTH},
                                           // Pixels that lack light are estimated, in float and in
                                           // double from other passes: double is proposed.
                                           {"tests/scenes/five-panes.lua", false, WIDTH / 3},
                                           {"tests/scenes/bright-panel.lua", true, WIDTH},
                                           {"tests/scenes/ground-sphere.lua", false, WIDTH}};
    for (size_t i = 0; i < sizeof scenes / sizeof *scenes; i++) {
        Scene *scene = load_scene(scenes[i].path);
        RenderSettings settings = render_settings_default(scene);
        NeedsRequest request = request_of(scene, &settings, 1);
        request.width = scenes[i].width;
        request.height = request.width * HEIGHT / WIDTH;
        Needs needs = find_needs(scene, &request);
        needs.settings.samples = 1; // Noise is judged apart.
        assert_false(needs_is_refuted(&needs));
        // Also of pictures that take less than a tick of the system.
        assert_true(needs.double_over_float_seconds > 0.2 && needs.double_over_float_seconds < 20);
        assert_at_most(fraction_off(scene, &needs, request.width), NEEDS_FRACTION_MAXIMUM,
                       "%s: share off", scenes[i].path);
        if ((needs.settings.engine->mantissa_bits == 24) != scenes[i].is_float) {
            fail_msg("%s: %s", scenes[i].path, needs.settings.engine->name);
        }
        scene_destroy(scene);
    }
}

/** What quad alone cures makes no setting finer: each correction helps, by itself or with others.
 */
static void test_corrections_help(void **state) {
    (void)state;
    Scene *scene = load_scene("tests/scenes/glass-cones.lua");
    RenderSettings settings = render_settings_default(scene);
    NeedsRequest request = request_of(scene, &settings, 1);
    request.width = WIDTH / 3;
    request.height = HEIGHT / 3;
    Needs needs = find_needs(scene, &request);
    assert_int_equal((int)needs.check_count, 2);
    assert_true(needs_is_refuted(&needs)); // By quad: light is trapped for hundreds of turns.
    for (int i = 0; i < needs.correction_count; i++) {
        const NeedsCorrection *correction = &needs.corrections[i];
        assert_true(correction->without.off < correction->trial.off);
    }
    assert_true(needs.settings.cutoff >= CUTOFF_DEFAULT / 16);
    scene_destroy(scene);
}

/** Coarser tolerances move the edges of a sponge, and the search sees it: they are not "worth 0
 *  steps". */
static void test_tolerance_moves_edges(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/menger-sponge.lua");
    Needs needs = needs_of(scene, 1);
    assert_true(needs.has_sdf);
    assert_at_most(needs.settings.tolerance, 1, "tolerance");
    assert_true(needs.coarser_tolerance_trial.off > 100);
    assert_true(needs.own_tolerance_trial.off > 0);
    assert_false(needs.is_tolerance_sufficient);
    scene_destroy(scene);
}

/** What is said of rays per pixel agrees with the figures: too few can be told from four times as
 *  many, and where more are sufficient they are proposed. */
static void test_samples_are_raised(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    char words[8192];
    Needs needs = needs_of(scene, 4);
    needs_explain(&needs, words, sizeof words);
    assert_false(needs.is_noise_sufficient);
    assert_true(needs_trial_fails(&needs.noise[0].trial));
    assert_true(needs.noise_count > 1);
    assert_non_null(strstr(words, "can be told from a better one by its noise"));
    scene_destroy(scene);
    scene = load_scene("scenes/box.lua");
    RenderSettings settings = render_settings_default(scene);
    NeedsRequest request = request_of(scene, &settings, 1);
    request.error_steps = 64;
    needs = find_needs(scene, &request);
    needs_explain(&needs, words, sizeof words);
    assert_true(needs.is_noise_sufficient);
    assert_true(needs.settings.samples > 1);
    assert_null(strstr(words, "can be told from"));
    for (int i = 0; i < needs.noise_count; i++) {
        assert_true(needs_trial_fails(&needs.noise[i].trial) ==
                    (needs.noise[i].samples < needs.settings.samples));
    }
    scene_destroy(scene);
}

/** A larger error allows cheaper settings, never dearer ones. */
static void test_errors_in_order(void **state) {
    (void)state;
    static const double errors[] = {0.5, 4, 32};
    Scene *scene = load_scene("scenes/box.lua");
    RenderSettings settings = render_settings_default(scene);
    NeedsRequest request = request_of(scene, &settings, 1);
    int depth = DEPTH_MAXIMUM;
    for (size_t i = 0; i < sizeof errors / sizeof *errors; i++) {
        request.error_steps = errors[i];
        Needs needs = find_needs(scene, &request);
        assert_true(needs.settings.depth <= depth);
        assert_true(i == 0 || needs.settings.depth < DEPTH_MAXIMUM);
        depth = needs.settings.depth;
    }
    assert_true(depth < needs_of(scene, 1).settings.depth);
    scene_destroy(scene);
}

/** More time gives a better picture; what no time is enough for is said, with the fastest. */
static void test_budgets(void **state) {
    (void)state;
    Scene *scene = load_scene("scenes/box.lua");
    RenderSettings settings = render_settings_default(scene);
    NeedsRequest request = request_of(scene, &settings, 1);
    request.budget_seconds = 1e-6;
    Needs none = find_needs(scene, &request);
    assert_false(none.budget.is_met);
    assert_true(none.budget.seconds > request.budget_seconds);
    assert_int_equal(none.budget.settings.samples, 1);
    request.budget_seconds = 2 * none.budget.seconds;
    Needs little = find_needs(scene, &request);
    request.budget_seconds = 60 * none.budget.seconds;
    Needs much = find_needs(scene, &request);
    assert_true(much.budget.is_met);
    assert_at_most(much.budget.seconds, request.budget_seconds, "time");
    assert_true(much.budget.settings.samples > 1);
    assert_true(much.budget.trial.rms_steps < little.budget.trial.rms_steps);
    assert_true(much.budget.trial.rms_steps > 0);
    scene_destroy(scene);
}

/* --- charts ----------------------------------------------------------------------------------- */

/** Times whose quartiles overlap are equal: of such points with equal errors the first stands, and
 *  noise removes none. */
static void test_ties_of_the_front(void **state) {
    (void)state;
    TiedPoint points[] = {{0.21, 0.223, 0.24, 0, false},  // depth 1
                          {0.20, 0.211, 0.23, 0, false},  // depth 12: faster by noise alone
                          {0.10, 0.105, 0.11, 3, false},  // faster and less accurate
                          {0.10, 0.104, 0.12, 1, false},  // a tie in time, and more accurate
                          {0.50, 0.510, 0.52, 0, false}}; // slower
    static const bool front[] = {true, false, false, true, false};
    pareto_front_find_ties(points, sizeof points / sizeof *points, 1.02);
    for (size_t i = 0; i < sizeof points / sizeof *points; i++) {
        assert_true(points[i].is_pareto == front[i]);
    }
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_path_hashes_agree),
                                       cmocka_unit_test(test_sampling_cells),
                                       cmocka_unit_test(test_path_hashes_differ),
                                       cmocka_unit_test(test_forecasts),
                                       cmocka_unit_test(test_depths),
                                       cmocka_unit_test(test_no_picture_refutes),
                                       cmocka_unit_test(test_corrections_help),
                                       cmocka_unit_test(test_tolerance_moves_edges),
                                       cmocka_unit_test(test_samples_are_raised),
                                       cmocka_unit_test(test_errors_in_order),
                                       cmocka_unit_test(test_budgets),
                                       cmocka_unit_test(test_ties_of_the_front)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
