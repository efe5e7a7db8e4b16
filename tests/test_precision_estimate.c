/**
 * @file
 * @brief The estimate of float's errors, in both directions, against whole pictures in double.
 */
#include "load_scene.h"
#include "testing.h"

#include "base/encoding.h"
#include "dioptre/renderer.h"
#include "dioptre/script.h"
#include "render/precision_estimate.h"

#include <math.h>
#include <stdlib.h>

/** Size of the pictures. */
enum { WIDTH = 160, HEIGHT = 120, PIXELS = WIDTH * HEIGHT };

/** Largest fraction of wrong pixels in a picture for which float is chosen. */
#define FRACTION_ALLOWED 5e-4

/** Throughput below which rays end: both pictures lose the same light. */
#define CUTOFF 1.5e-4

/** A scene and its estimate. */
typedef struct Expectation {
    const char *path;     /**< Its file. */
    bool is_float;        /**< Whether float is chosen. */
    PrecisionCause cause; /**< If not: why. */
} Expectation;

/** Scenes that must be drawn in double, and their harmless neighbours. */
static const Expectation expectations[] = {
    {"tests/scenes/overlapping-balls.lua", false, PRECISION_TRAPPED_LIGHT},
    {"tests/scenes/bubbles.lua", false, PRECISION_TRAPPED_LIGHT},
    {"tests/scenes/touching-balls.lua", true, 0},
    {"scenes/glass-sphere.lua", true, 0},
    {"scenes/figure-18.lua", true, 0},
    {"scenes/melting.lua", true, 0},
    {"tests/scenes/telescope.lua", true, 0},
    {"tests/scenes/telescope-aslant.lua", false, PRECISION_DISTANCE}};

/** @return A scene from its file, in the size of the pictures. */
static Scene *load_small_scene(const char *path) {
    Scene *scene = load_scene(path);
    scene->image.width = WIDTH;
    scene->image.height = HEIGHT;
    return scene;
}

/** Traces a picture of a scene. */
static void trace_scene(const char *engine_name, const Scene *scene, double *rgb) {
    Error error = {0};
    const Engine *engine = engine_find(engine_name, &error);
    assert_non_null(engine);
    TraceSettings settings = render_settings_default(scene).trace;
    settings.cutoff = CUTOFF;
    settings.samples = 1;
    Tracer *tracer = engine->create_tracer(scene, &settings, &error);
    assert_non_null(tracer);
    PixelGrid grid = {.columns = WIDTH, .rows = HEIGHT, .stride = 1};
    RayCounts counts = {0};
    engine->set_view(tracer, scene, WIDTH, HEIGHT);
    engine->trace(tracer, &grid, rgb, &counts);
    engine->destroy(tracer);
}

/** @return The fraction of the pixels that float draws wrongly by more than a step. */
static double wrong_fraction(const Scene *scene) {
    static double single[3 * PIXELS], exact[3 * PIXELS];
    trace_scene("auto", scene, single);
    trace_scene("f64x1", scene, exact);
    int wrong = 0;
    for (int i = 0; i < PIXELS; i++) {
        double worst = 0;
        for (int channel = 0; channel < 3; channel++) {
            size_t at = (size_t)(channel * PIXELS + i);
            worst = fmax(worst, fabs(encoding_encode(ENCODING_SRGB, single[at]) -
                                     encoding_encode(ENCODING_SRGB, exact[at])));
        }
        wrong += worst > 1;
    }
    return (double)wrong / PIXELS;
}

/** The estimate says double where float draws pixels wrongly, and float where it does not. */
static void test_estimates(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof expectations / sizeof *expectations; i++) {
        const Expectation *row = &expectations[i];
        Scene *scene = load_small_scene(row->path);
        PrecisionEstimate estimate = precision_estimate_of(scene);
        double fraction = wrong_fraction(scene);
        printf("%-38s estimate %.2g steps, %.3g %% wrong in float\n", row->path,
               precision_estimate_error(&estimate), 100 * fraction);
        if ((precision_estimate_error(&estimate) < PRECISION_VISIBLE_ERROR) != row->is_float) {
            fail_msg("%s: estimate %g", row->path, precision_estimate_error(&estimate));
        }
        if (row->is_float) {
            assert_at_most(fraction, FRACTION_ALLOWED, "%s: wrong in float", row->path);
        } else {
            assert_int_equal((int)estimate.cause, (int)row->cause);
            assert_true(fraction > 0);
        }
        scene_destroy(scene);
    }
}

/** At few turns, light in overlapping glass is exact in float: double is not chosen. */
static void test_shallow_glass_needs_no_double(void **state) {
    (void)state;
    Scene *scene = load_small_scene("tests/scenes/overlapping-balls.lua");
    scene->image.depth = 8;
    PrecisionEstimate estimate = precision_estimate_of(scene);
    assert_true(precision_estimate_error(&estimate) < PRECISION_VISIBLE_ERROR);
    assert_at_most(wrong_fraction(scene), 0, "wrong at depth 8");
    scene_destroy(scene);
}

/** @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_estimates),
                                       cmocka_unit_test(test_shallow_glass_needs_no_double)};
    return cmocka_run_group_tests_name("precision estimate", tests, NULL, NULL);
}
