/**
 * @file
 * @brief Measures the time and the errors of the settings of a scene.
 *
 * One setting is changed at a time, as in the work-precision diagrams of Hairer and Wanner
 * (*Solving Ordinary Differential Equations II*, 1996). All are timed in turn, several times, so
 * that a drift of the clock affects all alike.
 */
#include "lab/charts/chart.h"

#include "base/pareto_front.h"
#include "lab/needs/image_difference.h"
#include "lab/needs/scaled_tolerance.h"
#include "lab/score_stats.h"
#include "render/rounding_witness.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** Errors count as equal up to this factor. */
#define EQUAL_ERROR_FACTOR 1.02

/** How often each setting is timed. */
enum { TURNS = 5 };

/** Depth and samples of references. */
enum { REFERENCE_MAX_DEPTH = DEPTH_MAXIMUM, REFERENCE_SAMPLES = 64 };
/** Cutoff of references, 8-bit steps. No cutoff at all would follow rays that panes of glass split
 *  without end; this one is a thousandth of a step. */
#define REFERENCE_CUTOFF 1e-3

/** Width and height of the picture, relative to those of the one whose pixels are rounded in three
 *  directions: that would otherwise take as long as all the rest. */
enum { ROUNDING_SIZE_DIVISOR = 2 };

/** Kinds of errors. */
typedef enum {
    ERROR_KIND_ROUNDING, /**< Rounding, against quad. */
    ERROR_KIND_MODEL,    /**< Truncation, against more depth or finer tolerances. */
    ERROR_KIND_SAMPLING  /**< Noise, against many samples. */
} ErrorKind;

/** A measurement in progress. */
typedef struct ChartMeasurement {
    const Scene *scene;             /**< The scene. */
    const RenderSettings *settings; /**< How it would be rendered. */
    const atomic_bool *stop;        /**< Given up once it is true; may be NULL. */
    PixelSet timed_pixels;          /**< The pixels that are timed. */
    PixelSet error_pixels;          /**< Those whose errors are measured. */
    PixelSet quad_pixels;           /**< Those that are traced in quad. */
    Chart *chart;                   /**< The result. */
} ChartMeasurement;

/** Fewest pixels whose error says anything. */
enum { ERROR_PIXELS_MINIMUM = 16 };

/** Is a #PixelTest: the pixels that are timed, in whole tiles. */
static bool pixel_is_in_timed_set(const void *context, int x, int y) {
    (void)context;
    return (x / 64 + 5 * (y / 16)) % 16 == 0;
}

/** Is a #PixelTest: the pixels that are traced in quad. */
static bool pixel_is_in_quad_set(const void *context, int x, int y) {
    const int cell = *(const int *)context;
    return pixel_is_sampled(context, x, y) && (x / cell + y / cell) % 4 == 0;
}

/** Adds a setting; of more than #CHART_POINTS_MAXIMUM it replaces the last. @return It, with the
 *  scene's own values. */
static ChartPoint *add_setting(ChartMeasurement *measure, const char *group, const char *label) {
    Chart *chart = measure->chart;
    chart->count += chart->count < CHART_POINTS_MAXIMUM;
    ChartPoint *point = &chart->points[chart->count - 1];
    *point = (ChartPoint){.setting = group,
                          .engine = measure->settings->engine,
                          .trace = measure->settings->trace,
                          .samples = measure->settings->samples,
                          .tolerance = 1};
    snprintf(point->label, sizeof point->label, "%s", label);
    return point;
}

/** Adds the engines. */
static void engines_add(ChartMeasurement *measure) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if (engine_is_supported(*engine) && (*engine)->mantissa_bits <= 53) {
            add_setting(measure, "engine", (*engine)->name)->engine = *engine;
        }
    }
}

/** Adds ray offsets. */
static void offsets_add(ChartMeasurement *measure) {
    add_setting(measure, "offset", "none")->trace.offset = OFFSET_NONE;
    for (double epsilon = 1e-6; epsilon < 0.05; epsilon *= 10) {
        char label[CHART_LABEL_SIZE];
        snprintf(label, sizeof label, "fixed %.0e", epsilon);
        ChartPoint *point = add_setting(measure, "offset", label);
        point->trace.offset = OFFSET_FIXED;
        point->trace.epsilon = epsilon;
    }
    add_setting(measure, "offset", "bound")->trace.offset = OFFSET_BOUND;
}

/** Adds depths. */
static void depths_add(ChartMeasurement *measure) {
    static const int depths[] = {0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64};
    bool is_recursive = scene_has_secondary_rays(measure->scene);
    for (size_t i = 0; is_recursive && i < sizeof depths / sizeof *depths; i++) {
        char label[CHART_LABEL_SIZE];
        snprintf(label, sizeof label, "depth %d", depths[i]);
        add_setting(measure, "depth", label)->trace.depth = depths[i];
    }
}

/** Adds cutoffs. */
static void cutoffs_add(ChartMeasurement *measure) {
    static const double cutoffs[] = {16, 4, 1, CUTOFF_DEFAULT, CUTOFF_DEFAULT / 16};
    bool is_recursive = scene_has_secondary_rays(measure->scene);
    for (size_t i = 0; is_recursive && i < sizeof cutoffs / sizeof *cutoffs; i++) {
        char label[CHART_LABEL_SIZE];
        snprintf(label, sizeof label, "cutoff %.3g", cutoffs[i]);
        add_setting(measure, "cutoff", label)->trace.cutoff = cutoffs[i];
    }
}

/** Adds samples. */
static void samples_add(ChartMeasurement *measure) {
    for (int samples = 1; samples <= REFERENCE_SAMPLES / 4; samples *= 2) {
        char label[CHART_LABEL_SIZE];
        snprintf(label, sizeof label, "%d ray%s", samples, samples == 1 ? "" : "s");
        add_setting(measure, "samples", label)->samples = samples;
    }
}

/** Adds tolerances. */
static void tolerances_add(ChartMeasurement *measure) {
    bool is_marched = scene_has_tolerances(measure->scene);
    for (double factor = 0.25; is_marched && factor <= 256; factor *= 4) {
        char label[CHART_LABEL_SIZE];
        snprintf(label, sizeof label, "tolerance x %g", factor);
        add_setting(measure, "tolerance", label)->tolerance = factor;
    }
}

/** Adds rendering with and without BVH. */
static void bvh_modes_add(ChartMeasurement *measure) {
    add_setting(measure, "tree", "no tree")->trace.bvh = BVH_NEVER;
    add_setting(measure, "tree", "tree")->trace.bvh = BVH_ALWAYS;
}

/** Renders a setting. @return false if anything is wrong. */
static bool point_render(const ChartMeasurement *measure, const PixelSet *pixels,
                         const ChartPoint *point, SampledRender *render, Error *error) {
    ScaledToleranceScene scaled;
    if (!scaled_tolerance_scene_init(&scaled, measure->scene, point->tolerance, error)) {
        return false;
    }
    const Scene *scene = point->tolerance == 1 ? measure->scene : &scaled.scene;
    RenderContext render_context = {scene, pixels, measure->settings->threads, measure->stop};
    Variant variant = {
        .engine = point->engine, .trace = point->trace, .samples_traced = point->samples};
    variant.trace.samples = point->samples;
    bool is_taken = render_samples(&render_context, &variant, render, error);
    scaled_tolerance_scene_deinit(&scaled);
    return is_taken;
}

/** Times all settings in turn. @return false if anything is wrong. */
static bool time_points(ChartMeasurement *measure, Error *error) {
    Chart *chart = measure->chart;
    double seconds[CHART_POINTS_MAXIMUM][TURNS];
    double megapixels = 1e-6 * (double)measure->timed_pixels.count;
    for (int turn = 0; turn < TURNS; turn++) {
        for (size_t i = 0; i < chart->count; i++) {
            SampledRender render;
            if (!point_render(measure, &measure->timed_pixels, &chart->points[i], &render, error)) {
                return false;
            }
            seconds[i][turn] = render.cpu_seconds / megapixels;
            sampled_render_deinit(&render);
        }
    }
    for (size_t i = 0; i < chart->count; i++) {
        Quartiles quartiles = quartiles_of(seconds[i], TURNS);
        chart->points[i].seconds_low = quartiles.low;
        chart->points[i].seconds = quartiles.median;
        chart->points[i].seconds_high = quartiles.high;
    }
    return true;
}

/** Replaces the samples of each pixel by their mean; path hashes become meaningless. */
static void average_samples(SampledRender *render, size_t pixels) {
    size_t samples = render->ray_count / pixels;
    for (size_t i = 0; i < 3 * pixels; i++) {
        double sum = 0;
        for (size_t sample = 0; sample < samples; sample++) {
            sum += render->rgb[3 * pixels * sample + i];
        }
        render->rgb[i] = sum / (double)samples;
    }
    render->ray_count = pixels;
}

/** @return The kind of a group's own errors. */
static ErrorKind error_kind_of(const char *group) {
    bool is_truncation = strcmp(group, "depth") == 0 || strcmp(group, "cutoff") == 0 ||
                         strcmp(group, "tolerance") == 0;
    return strcmp(group, "samples") == 0 ? ERROR_KIND_SAMPLING
           : is_truncation               ? ERROR_KIND_MODEL
                                         : ERROR_KIND_ROUNDING;
}

/** @return The reference of a setting's own error. */
static ChartPoint reference_of(const ChartPoint *point, ErrorKind kind) {
    ChartPoint truth = *point;
    if (kind == ERROR_KIND_ROUNDING) {
        truth.engine = engine_with_role(ENGINE_REFERENCE);
        truth.trace.offset = OFFSET_BOUND;
    } else if (kind == ERROR_KIND_MODEL) {
        truth.trace.depth =
            strcmp(point->setting, "depth") == 0 ? REFERENCE_MAX_DEPTH : truth.trace.depth;
        truth.trace.cutoff = REFERENCE_CUTOFF;
        truth.tolerance = 1.0 / 16;
    } else {
        truth.samples = REFERENCE_SAMPLES;
    }
    return truth;
}

/** Measures a setting's own error. @return false if anything is wrong. */
static bool point_measure_own_error(const ChartMeasurement *measure, ChartPoint *point,
                                    Error *error) {
    ErrorKind kind = error_kind_of(point->setting);
    ChartPoint mine = *point;
    mine.samples = kind == ERROR_KIND_SAMPLING ? point->samples : 1;
    ChartPoint other = reference_of(&mine, kind);
    const PixelSet *pixels =
        kind == ERROR_KIND_ROUNDING ? &measure->quad_pixels : &measure->error_pixels;
    SampledRender render, reference_render;
    if (!point_render(measure, pixels, &mine, &render, error)) {
        return false;
    }
    bool is_done = point_render(measure, pixels, &other, &reference_render, error);
    if (is_done) {
        if (kind == ERROR_KIND_SAMPLING) {
            average_samples(&render, pixels->count);
            average_samples(&reference_render, pixels->count);
        }
        bool compares_paths =
            kind == ERROR_KIND_ROUNDING || strcmp(point->setting, "tolerance") == 0;
        Encoding encoding = (Encoding)measure->settings->encoding;
        ImageDifference difference = image_difference_of(
            &render, &reference_render, compares_paths ? &reference_render : NULL, encoding);
        bool uses_total_error = strcmp(point->setting, "offset") == 0 || kind == ERROR_KIND_MODEL;
        // Rays that hit their own surface again are on another path: that is the error.
        point->own_error = uses_total_error ? difference.total_rms : difference.same_path_rms;
        point->max_steps = difference.max_steps;
        point->edge_flip_fraction = (double)difference.edge_flips / (double)difference.rays;
        sampled_render_deinit(&reference_render);
    }
    sampled_render_deinit(&render);
    return is_done;
}

/** Measures the error of a setting's picture. @return false if anything is wrong. */
static bool point_measure_total_error(const ChartMeasurement *measure,
                                      const SampledRender *reference_render, ChartPoint *point,
                                      Error *error) {
    SampledRender render;
    if (!point_render(measure, &measure->error_pixels, point, &render, error)) {
        return false;
    }
    average_samples(&render, measure->error_pixels.count);
    Encoding encoding = (Encoding)measure->settings->encoding;
    point->total_error = image_difference_of(&render, reference_render, NULL, encoding).total_rms;
    sampled_render_deinit(&render);
    return true;
}

/** Measures which pixels change when numbers are rounded up and down. @return false if anything is
 *  wrong. */
static bool point_measure_rounding(const ChartMeasurement *measure, ChartPoint *point,
                                   Error *error) {
    ScaledToleranceScene scaled;
    LayerStats stats = {.pixel_count = 0};
    RenderSettings settings = *measure->settings;
    settings.engine = point->engine;
    settings.trace = point->trace;
    settings.samples = 1;
    settings.width = (settings.width + 1) / ROUNDING_SIZE_DIVISOR;
    settings.height = (settings.height + 1) / ROUNDING_SIZE_DIVISOR;
    if (!scaled_tolerance_scene_init(&scaled, measure->scene, point->tolerance, error)) {
        return false;
    }
    Renderer *renderer = renderer_create(&scaled.scene, &settings, error);
    bool is_done = renderer && renderer_measure_layer(renderer, &scaled.scene, LAYER_ROUNDING,
                                                      measure->stop, &stats, error);
    renderer_destroy(renderer);
    scaled_tolerance_scene_deinit(&scaled);
    if (is_done) {
        double fraction = (double)stats.artifact_pixels / (double)stats.pixel_count;
        point->rounding_fraction = rounding_is_supported() ? fraction : NAN;
    }
    return is_done;
}

/** Measures all errors. @return false if anything is wrong. */
static bool points_measure_errors(ChartMeasurement *measure, Error *error) {
    SampledRender reference_render;
    ChartPoint best = {.engine = engine_scalar(engine_with_role(ENGINE_DOUBLE)),
                       .trace = measure->settings->trace,
                       .samples = REFERENCE_SAMPLES,
                       .tolerance = 1.0 / 16};
    best.trace.depth = REFERENCE_MAX_DEPTH;
    best.trace.cutoff = REFERENCE_CUTOFF;
    best.trace.offset = OFFSET_BOUND;
    if (!point_render(measure, &measure->error_pixels, &best, &reference_render, error)) {
        return false;
    }
    average_samples(&reference_render, measure->error_pixels.count);
    bool is_done = true;
    for (size_t i = 0; is_done && i < measure->chart->count; i++) {
        ChartPoint *point = &measure->chart->points[i];
        is_done = point_measure_own_error(measure, point, error) &&
                  point_measure_total_error(measure, &reference_render, point, error) &&
                  point_measure_rounding(measure, point, error);
    }
    sampled_render_deinit(&reference_render);
    return is_done;
}

/** Finds the settings that no other beats in both time and error. */
static void find_pareto_front(Chart *chart) {
    TiedPoint points[CHART_POINTS_MAXIMUM];
    for (size_t i = 0; i < chart->count; i++) {
        const ChartPoint *point = &chart->points[i];
        points[i] = (TiedPoint){point->seconds_low, point->seconds, point->seconds_high,
                                point->total_error, false};
    }
    pareto_front_find_ties(points, chart->count, EQUAL_ERROR_FACTOR);
    for (size_t i = 0; i < chart->count; i++) {
        chart->points[i].is_pareto = points[i].is_pareto;
    }
}

/** Measures everything. @return false if anything is wrong. */
static bool measure_all(ChartMeasurement *measure, Error *error) {
    engines_add(measure);
    offsets_add(measure);
    depths_add(measure);
    cutoffs_add(measure);
    samples_add(measure);
    tolerances_add(measure);
    bvh_modes_add(measure);
    if (!time_points(measure, error) || !points_measure_errors(measure, error)) {
        return false;
    }
    find_pareto_front(measure->chart);
    return true;
}

bool chart_measure(const Scene *scene, const RenderSettings *settings, const atomic_bool *stop,
                   Chart *chart, Error *error) {
    ChartMeasurement measure = {.scene = scene, .settings = settings, .stop = stop, .chart = chart};
    int width = settings->width, height = settings->height, cell = sampling_cell_of(width, height);
    *chart = (Chart){.count = 0};
    bool is_done =
        pixel_set_init(&measure.timed_pixels, width, height, pixel_is_in_timed_set, NULL, error) &&
        pixel_set_init(&measure.error_pixels, width, height, pixel_is_sampled, &cell, error) &&
        pixel_set_init(&measure.quad_pixels, width, height, pixel_is_in_quad_set, &cell, error) &&
        ((measure.error_pixels.count >= ERROR_PIXELS_MINIMUM && measure.quad_pixels.count > 0 &&
          measure.timed_pixels.count > 0) ||
         error_set(error, STATUS_USAGE, "a picture of %d x %d has too few pixels for a chart",
                   width, height)) &&
        measure_all(&measure, error);
    pixel_set_deinit(&measure.timed_pixels);
    pixel_set_deinit(&measure.error_pixels);
    pixel_set_deinit(&measure.quad_pixels);
    return is_done;
}
