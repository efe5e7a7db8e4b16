/**
 * @file
 * @brief Measuring what the settings of a scene cost, and what errors they leave.
 *
 * One setting is changed at a time (Hairer, Wanner, *Solving Ordinary Differential Equations II*,
 * 1996, draw work against precision so). All are timed in turn, again and again, so that a clock
 * that drifts drifts for all.
 */
#include "dioptre/chart.h"

#include "lab/contrast.h"
#include "lab/variation.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/** How many times as large an error may be and count as the same. */
#define ALIKE 1.01

/** How often each setting is timed. */
enum { TURNS = 5 };

/** Depth and samples of the truth. */
enum { TRUTH_DEPTH = 128, TRUTH_SAMPLES = 64 };

/** Of a group's own errors, which kind they are. */
typedef enum {
    KIND_ROUNDING, /**< The same rays in quad. */
    KIND_MODEL,    /**< In the same numbers, but everything followed. */
    KIND_SAMPLING  /**< Many samples. */
} Kind;

/** A measurement under way. */
typedef struct Measure {
    const Scene *scene;             /**< The scene. */
    const RenderSettings *settings; /**< How it would be drawn. */
    const atomic_bool *stop;        /**< Whether to give up. */
    Pixels timed;                   /**< The pixels that are timed. */
    Pixels tried;                   /**< Those whose errors are measured. */
    Pixels few;                     /**< Those that quad is asked about. */
    Chart *chart;                   /**< What is known. */
} Measure;

/** @return Whether a pixel is timed: whole blocks, here and there. See #PixelTest.
 *  @param context Not looked at. @param x Its column. @param y Its row. */
static bool pixel_is_timed(const void *context, int x, int y) {
    (void)context;
    return (x / 64 + 5 * (y / 16)) % 16 == 0;
}

/** @return Whether quad is asked about a pixel. See #PixelTest. @param context Not looked at.
 *  @param x Its column. @param y Its row. */
static bool pixel_is_few(const void *context, int x, int y) {
    return pixel_is_sampled(context, x, y) && (x / 8 + y / 8) % 4 == 0;
}

/** Adds a setting. @param[in,out] measure The measurement. @param group What is set.
 *  @param label To what. @return It, as the scene has all others; NULL: there are too many. */
static ChartPoint *point_add(Measure *measure, const char *group, const char *label) {
    static ChartPoint none; // What cannot be kept is set here and forgotten.
    Chart *chart = measure->chart;
    ChartPoint *point =
        chart->count < CHART_POINTS_MAXIMUM ? &chart->points[chart->count++] : &none;
    *point = (ChartPoint){.group = group,
                          .engine = measure->settings->engine,
                          .trace = measure->settings->trace,
                          .samples = measure->settings->samples,
                          .tolerance = 1};
    snprintf(point->label, sizeof point->label, "%s", label);
    return point;
}

/** Adds the engines. @param[in,out] measure The measurement. */
static void engines_add(Measure *measure) {
    for (const Engine *const *engine = engine_list(); *engine; engine++) {
        if (engine_is_supported(*engine) && (*engine)->mantissa_bits <= 53) {
            point_add(measure, "engine", (*engine)->name)->engine = *engine;
        }
    }
}

/** Adds ways to leave a surface. @param[in,out] measure The measurement. */
static void offsets_add(Measure *measure) {
    point_add(measure, "offset", "none")->trace.offset = OFFSET_NONE;
    for (double epsilon = 1e-6; epsilon < 0.05; epsilon *= 10) {
        char label[CHART_LABEL_SIZE];
        snprintf(label, sizeof label, "fixed %.0e", epsilon);
        ChartPoint *point = point_add(measure, "offset", label);
        point->trace.offset = OFFSET_FIXED;
        point->trace.epsilon = epsilon;
    }
    point_add(measure, "offset", "bound")->trace.offset = OFFSET_BOUND;
}

/** Adds depths. @param[in,out] measure The measurement. */
static void depths_add(Measure *measure) {
    static const int depths[] = {0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64};
    bool is_recursive = scene_has_mirrors(measure->scene) || scene_has_glass(measure->scene);
    for (size_t i = 0; is_recursive && i < sizeof depths / sizeof *depths; i++) {
        char label[CHART_LABEL_SIZE];
        snprintf(label, sizeof label, "depth %d", depths[i]);
        point_add(measure, "depth", label)->trace.depth = depths[i];
    }
}

/** Adds samples. @param[in,out] measure The measurement. */
static void samples_add(Measure *measure) {
    for (int samples = 1; samples <= TRUTH_SAMPLES / 4; samples *= 2) {
        char label[CHART_LABEL_SIZE];
        snprintf(label, sizeof label, "%d ray%s", samples, samples == 1 ? "" : "s");
        point_add(measure, "samples", label)->samples = samples;
    }
}

/** Adds tolerances. @param[in,out] measure The measurement. */
static void tolerances_add(Measure *measure) {
    bool is_marched = variation_is_possible(measure->scene, engine_list()[0]->shape_keywords);
    for (double factor = 0.25; is_marched && factor <= 256; factor *= 4) {
        char label[CHART_LABEL_SIZE];
        snprintf(label, sizeof label, "tolerance x %g", factor);
        point_add(measure, "tolerance", label)->tolerance = factor;
    }
}

/** Adds the tree. @param[in,out] measure The measurement. */
static void trees_add(Measure *measure) {
    point_add(measure, "tree", "no tree")->trace.tree = TREE_NEVER;
    point_add(measure, "tree", "tree")->trace.tree = TREE_ALWAYS;
}

/** Shoots a setting. @param measure The measurement. @param pixels Which pixels. @param point The
 *  setting. @param[out] shot The shot. @param[out] error What is wrong. @return false if anything
 *  is. */
static bool point_shoot(const Measure *measure, const Pixels *pixels, const ChartPoint *point,
                        Shot *shot, Error *error) {
    Variation variation;
    if (!variation_make(&variation, measure->scene, point->engine->shape_keywords, point->tolerance,
                        error)) {
        return false;
    }
    const Scene *scene = point->tolerance == 1 ? measure->scene : &variation.scene;
    Studio studio = {scene, pixels, measure->settings->threads, measure->stop};
    Manner manner = {.engine = point->engine, .trace = point->trace, .rays = point->samples};
    manner.trace.samples = point->samples;
    bool is_taken = shot_take(&studio, &manner, shot, error);
    variation_release(&variation);
    return is_taken;
}

/** @return Order of two numbers, for qsort. @param a One. @param b The other. */
static int compare_numbers(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/** Times all settings in turn. @param[in,out] measure The measurement. @param[out] error What is
 *  wrong. @return false if anything is. */
static bool points_time(Measure *measure, Error *error) {
    Chart *chart = measure->chart;
    double seconds[CHART_POINTS_MAXIMUM][TURNS];
    double megapixels = 1e-6 * (double)measure->timed.count;
    for (int turn = 0; turn < TURNS; turn++) {
        for (size_t i = 0; i < chart->count; i++) {
            Shot shot;
            if (!point_shoot(measure, &measure->timed, &chart->points[i], &shot, error)) {
                return false;
            }
            seconds[i][turn] = shot.seconds / megapixels;
            shot_release(&shot);
        }
    }
    for (size_t i = 0; i < chart->count; i++) {
        qsort(seconds[i], TURNS, sizeof **seconds, compare_numbers);
        chart->points[i].seconds_low = seconds[i][TURNS / 4];
        chart->points[i].seconds = seconds[i][TURNS / 2];
        chart->points[i].seconds_high = seconds[i][TURNS - 1 - TURNS / 4];
    }
    return true;
}

/** Takes the mean of the samples of each pixel: then a shot has one ray a pixel. Trails are lost.
 *  @param[in,out] shot The shot. @param pixels How many pixels. */
static void shot_flatten(Shot *shot, size_t pixels) {
    size_t samples = shot->count / pixels;
    for (size_t i = 0; i < 3 * pixels; i++) {
        double sum = 0;
        for (size_t sample = 0; sample < samples; sample++) {
            sum += shot->rgb[3 * pixels * sample + i];
        }
        shot->rgb[i] = sum / (double)samples;
    }
    shot->count = pixels;
}

/** @return Of which kind a group's own errors are. @param group The group. */
static Kind kind_of(const char *group) {
    bool is_model = strcmp(group, "depth") == 0 || strcmp(group, "tolerance") == 0;
    return strcmp(group, "samples") == 0 ? KIND_SAMPLING : is_model ? KIND_MODEL : KIND_ROUNDING;
}

/** @return What a setting's own error is measured against. @param point The setting. @param kind Of
 *  its error. */
static ChartPoint truth_of(const ChartPoint *point, Kind kind) {
    ChartPoint truth = *point;
    if (kind == KIND_ROUNDING) {
        truth.engine = engine_find("f128x1", NULL);
        truth.trace.offset = OFFSET_BOUND;
    } else if (kind == KIND_MODEL) {
        truth.trace.depth = strcmp(point->group, "depth") == 0 ? TRUTH_DEPTH : truth.trace.depth;
        truth.tolerance = 1.0 / 16;
    } else {
        truth.samples = TRUTH_SAMPLES;
    }
    return truth;
}

/** Finds a setting's own error. @param measure The measurement. @param[in,out] point The setting.
 *  @param[out] error What is wrong. @return false if anything is. */
static bool point_compare(const Measure *measure, ChartPoint *point, Error *error) {
    Kind kind = kind_of(point->group);
    ChartPoint mine = *point;
    mine.samples = kind == KIND_SAMPLING ? point->samples : 1;
    ChartPoint other = truth_of(&mine, kind);
    const Pixels *pixels = kind == KIND_ROUNDING ? &measure->few : &measure->tried;
    Shot shot, truth;
    if (!point_shoot(measure, pixels, &mine, &shot, error)) {
        return false;
    }
    bool is_done = point_shoot(measure, pixels, &other, &truth, error);
    if (is_done) {
        if (kind == KIND_SAMPLING) {
            shot_flatten(&shot, pixels->count);
            shot_flatten(&truth, pixels->count);
        }
        bool has_ways = kind == KIND_ROUNDING || strcmp(point->group, "tolerance") == 0;
        Encoding encoding = (Encoding)measure->settings->encoding;
        Contrast contrast = contrast_of(&shot, &truth, has_ways ? &truth : NULL, encoding);
        bool is_way = strcmp(point->group, "offset") == 0 || kind == KIND_MODEL;
        // Rays that met their own surface, or passed it, took another way: that is the error.
        point->own = is_way ? contrast.whole : contrast.mean;
        point->steps = contrast.worst;
        point->flips = (double)contrast.flips / (double)contrast.rays;
        shot_release(&truth);
    }
    shot_release(&shot);
    return is_done;
}

/** Finds the error of a setting's whole picture. @param measure The measurement. @param truth The
 *  picture as it should be. @param[in,out] point The setting. @param[out] error What is wrong.
 *  @return false if anything is. */
static bool point_sum(const Measure *measure, const Shot *truth, ChartPoint *point, Error *error) {
    Shot shot;
    if (!point_shoot(measure, &measure->tried, point, &shot, error)) {
        return false;
    }
    shot_flatten(&shot, measure->tried.count);
    Encoding encoding = (Encoding)measure->settings->encoding;
    point->total = contrast_of(&shot, truth, NULL, encoding).whole;
    shot_release(&shot);
    return true;
}

/** Finds all errors. @param[in,out] measure The measurement. @param[out] error What is wrong.
 *  @return false if anything is. */
static bool points_compare(Measure *measure, Error *error) {
    Shot truth;
    ChartPoint best = {.engine = engine_find("f64x1", NULL),
                       .trace = measure->settings->trace,
                       .samples = TRUTH_SAMPLES,
                       .tolerance = 1.0 / 16};
    best.trace.depth = TRUTH_DEPTH;
    best.trace.offset = OFFSET_BOUND;
    if (!point_shoot(measure, &measure->tried, &best, &truth, error)) {
        return false;
    }
    shot_flatten(&truth, measure->tried.count);
    bool is_done = true;
    for (size_t i = 0; is_done && i < measure->chart->count; i++) {
        ChartPoint *point = &measure->chart->points[i];
        is_done = point_compare(measure, point, error) && point_sum(measure, &truth, point, error);
    }
    shot_release(&truth);
    return is_done;
}

/** Finds the settings that nothing beats in both time and error. @param[in,out] chart The chart. */
static void front_find(Chart *chart) {
    for (size_t i = 0; i < chart->count; i++) {
        ChartPoint *point = &chart->points[i];
        point->is_front = true;
        for (size_t k = 0; k < chart->count; k++) {
            const ChartPoint *other = &chart->points[k];
            bool beats = other->seconds < point->seconds && other->total <= ALIKE * point->total;
            point->is_front = point->is_front && !beats;
        }
    }
}

/** Measures everything. @param[in,out] measure The measurement, with its pixels. @param[out] error
 *  What is wrong. @return false if anything is. */
static bool measure_run(Measure *measure, Error *error) {
    engines_add(measure);
    offsets_add(measure);
    depths_add(measure);
    samples_add(measure);
    tolerances_add(measure);
    trees_add(measure);
    if (!points_time(measure, error) || !points_compare(measure, error)) {
        return false;
    }
    front_find(measure->chart);
    return true;
}

bool chart_measure(const Scene *scene, const RenderSettings *settings, const atomic_bool *stop,
                   Chart *chart, Error *error) {
    Measure measure = {.scene = scene, .settings = settings, .stop = stop, .chart = chart};
    int width = settings->width, height = settings->height;
    *chart = (Chart){.count = 0};
    bool is_done =
        pixels_make(&measure.timed, width, height, pixel_is_timed, NULL, error) &&
        pixels_make(&measure.tried, width, height, pixel_is_sampled, NULL, error) &&
        pixels_make(&measure.few, width, height, pixel_is_few, NULL, error) &&
        ((measure.few.count > 0 && measure.timed.count > 0) ||
         error_set(error, STATUS_USAGE, "a picture of %d x %d has too few pixels for a chart",
                   width, height)) &&
        measure_run(&measure, error);
    pixels_release(&measure.timed);
    pixels_release(&measure.tried);
    pixels_release(&measure.few);
    return is_done;
}
