/**
 * @file
 * @brief Tests of the laboratory: bad methods fail as expected, good ones and the tracer do not,
 *        and runs are reproducible.
 *
 * One table has a row per expectation. Good methods have the bounds of their design. The bounds of
 * bad methods are so far from their results that rounding does not matter.
 */
#include "base/pareto_front.h"
#include "lab/charts/metrics.h"
#include "lab/charts/table.h"
#include "lab/experiments/experiments.h"
#include "lab/score_stats.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/** Samples per level: fewer than in the laboratory, but enough for a quantile of 0.999. */
enum { EXPERIMENT_SAMPLES = 3000 };

/** The expected range of a result. */
typedef struct Expectation {
    const char *experiment; /**< The experiment. */
    const char *method;     /**< The method. */
    const char *type;       /**< The number type. */
    double level;           /**< The level. */
    const char *metric;     /**< Column of the CSV. */
    double low;             /**< Least value. */
    double high;            /**< Largest value. */
} Expectation;

/** No upper bound. */
#define ANY_VALUE HUGE_VAL

/** All expectations. */
static const Expectation expectations[] = {
    // Spheres far away: the quadratic loses them, projection does not.
    {"sphere-distance", "expanded", "float", 100, "ulps_p999", 300, ANY_VALUE},
    {"sphere-distance", "textbook", "float", 1e3, "false_hits", 0.2, 1},
    {"sphere-distance", "textbook", "float", 1e4, "false_misses", 0.1, 0.5},
    {"sphere-distance", "textbook", "double", 1e4, "ulps_p999", 1e4, ANY_VALUE},
    {"sphere-distance", "textbook", "double", 1e3, "false_misses", 0, 0},
    {"sphere-distance", "relative projection", "float", 1e4, "false_misses", 0, 1e-3},
    {"sphere-distance", "relative projection", "float", 1e3, "ulps_p999", 0, 8},
    {"sphere-distance", "relative projection", "float", 1.01, "ulps_p999", 20, ANY_VALUE},
    {"sphere-distance", "Haines", "float", 1e4, "ulps_p999", 0, 8},
    {"sphere-distance", "mixed", "float", 1e6, "ulps_max", 0, 0.6},
    {"sphere-distance", "mixed", "float", 1e6, "false_misses", 0, 0},
    {"sphere-distance", "compensated", "float", 1.01, "ulps_max", 0, 4},
    {"sphere-distance", "Quilez", "float", 1e3, "ulps_p999", 0, 8},
    {"sphere-ground", "Quilez", "float", 1e5, "error_median", 1e-4, ANY_VALUE},
    {"plane-point", "Quilez", "float", 1e6, "error_max", 0, 4.8e-7},
    {"sphere-distance", "dioptre", "float", 1.01, "ulps_max", 0, 2},
    {"sphere-distance", "dioptre", "float", 1e6, "ulps_max", 0, 2},
    {"sphere-distance", "dioptre", "float", 1e6, "false_misses", 0, 0},
    {"sphere-distance", "dioptre", "float", 1e6, "false_hits", 0, 0},
    {"sphere-distance", "dioptre", "double", 1e4, "ulps_p999", 0, 32},
    {"sphere-distance", "dioptre", "double", 1e6, "false_misses", 0, 0},
    // Far from the origin.
    {"sphere-world", "expanded", "float", 1e3, "false_misses", 0.01, 0.2},
    {"sphere-world", "projection", "float", 1e5, "ulps_p999", 1e3, ANY_VALUE},
    {"sphere-world", "relative projection", "float", 1e6, "ulps_p999", 0, 8},
    {"sphere-world", "dioptre", "float", 1e6, "ulps_max", 0, 2},
    {"sphere-world", "dioptre", "float", 1e6, "false_misses", 0, 0},
    // Every scale is alike.
    {"sphere-scale", "relative projection", "float", 1e-6, "ulps_p999", 0, 8},
    {"sphere-scale", "dioptre", "float", 1e-6, "ulps_max", 0, 2},
    {"sphere-scale", "dioptre", "float", 1e6, "ulps_max", 0, 2},
    // The ground: plain float is inaccurate.
    {"sphere-ground", "relative projection", "float", 1e5, "error_median", 1e-4, ANY_VALUE},
    {"sphere-ground", "Haines", "float", 1e5, "error_median", 1e-4, ANY_VALUE},
    {"sphere-ground", "compensated", "float", 1e6, "error_p999", 0, 1e-6},
    {"sphere-ground", "mixed", "float", 1e6, "error_max", 0, 6e-8},
    {"sphere-ground", "dioptre", "float", 1e6, "error_max", 0, 2.4e-7},
    // Cylinders.
    {"cylinder-distance", "B^2-AC", "float", 1e4, "false_misses", 0.1, 0.6},
    {"cylinder-distance", "B^2-AC", "float", 100, "ulps_median", 10, ANY_VALUE},
    {"cylinder-distance", "cross product", "float", 1e4, "false_misses", 0, 1e-3},
    {"cylinder-distance", "cross product", "float", 1e4, "error_p999", 0, 4e-7},
    {"cylinder-distance", "dioptre", "float", 1e4, "error_max", 0, 4e-7},
    {"cylinder-distance", "dioptre", "float", 1e4, "false_misses", 0, 0},
    {"cylinder-rim", "three parts", "float", 1, "leaks", 0.005, 0.05},
    {"cylinder-rim", "three parts", "double", 1, "leaks", 0.003, 0.05},
    {"cylinder-rim", "three parts", "float", 1, "double_hits", 0.4, 0.8},
    {"cylinder-rim", "interval", "float", 1, "leaks", 0, 0},
    {"cylinder-rim", "Quilez", "float", 1, "leaks", 0.2, 0.7},
    {"cylinder-rim", "dioptre", "float", 1, "leaks", 0, 0},
    {"cylinder-rim", "dioptre", "double", 1e4, "leaks", 0, 0},
    // Planes: 4 u / sin(angle) with a stored offset.
    {"plane-angle", "by its offset", "float", 0.01, "error_p999", 1e-5, 1.4e-3},
    {"plane-angle", "dioptre", "float", 0.01, "error_max", 0, 1e-6},
    {"plane-angle", "dioptre", "double", 0.01, "error_max", 0, 2.6e-12},
    {"plane-point", "by a point", "float", 1e6, "error_p999", 1e-3, ANY_VALUE},
    {"plane-point", "by its offset", "float", 1e6, "error_max", 0, 4.8e-7},
    {"plane-point", "dioptre", "float", 1e6, "error_max", 0, 4.8e-7},
    {"plane-point", "dioptre", "double", 1e6, "error_max", 0, 8.9e-16},
    // Triangles: no leaks where neighbours compute the same edge function.
    {"triangle-edges", "Cramer", "float", 1, "leaks", 0.02, 0.2},
    {"triangle-edges", "Moeller-Trumbore", "float", 1, "leaks", 0.05, 0.2},
    {"triangle-edges", "Moeller-Trumbore", "double", 1, "leaks", 0.05, 0.2},
    {"triangle-edges", "Moeller-Trumbore strict", "float", 1, "leaks", 0.2, 0.6},
    {"triangle-edges", "Moeller-Trumbore tolerant", "float", 1, "leaks", 0, 0},
    {"triangle-edges", "Moeller-Trumbore tolerant", "float", 1, "double_hits", 0.9, 1},
    {"triangle-edges", "signed volumes", "float", 1, "leaks", 0, 0},
    {"triangle-edges", "watertight", "float", 1e4, "leaks", 0, 0},
    {"triangle-edges", "watertight", "float", 1, "double_hits", 0, 0.05},
    {"triangle-edges", "dioptre", "float", 1, "leaks", 0, 0},
    {"triangle-edges", "dioptre", "double", 1e4, "leaks", 0, 0},
    {"triangle-corners", "Moeller-Trumbore", "double", 1, "leaks", 0.03, 0.2},
    {"triangle-corners", "Moeller-Trumbore strict", "float", 1, "leaks", 0.4, 0.8},
    {"triangle-corners", "signed volumes", "float", 1, "leaks", 0.002, 0.05},
    {"triangle-corners", "watertight", "float", 1, "leaks", 0, 0},
    {"triangle-corners", "dioptre", "float", 1, "leaks", 0, 0},
    {"triangle-corners", "dioptre", "double", 1e4, "leaks", 0, 0},
    {"triangle-small", "Moeller-Trumbore with cut", "float", 1e-2, "false_misses", 0, 0.01},
    {"triangle-small", "Moeller-Trumbore with cut", "float", 1e-3, "false_misses", 1, 1},
    {"triangle-small", "Moeller-Trumbore", "float", 1e-6, "false_misses", 0, 0.01},
    {"triangle-small", "dioptre", "float", 1e-6, "false_misses", 0, 0.01},
    {"triangle-thin", "watertight", "float", 1e5, "ulps_p999", 500, ANY_VALUE},
    {"triangle-thin", "dioptre", "float", 1e6, "ulps_max", 0, 2},
    {"triangle-thin", "dioptre", "double", 1e6, "ulps_max", 0, 16},
    {"triangle-edges", "Baldwin-Weber", "float", 1, "leaks", 0.03, 0.15},
    {"triangle-edges", "Baldwin-Weber", "double", 1, "leaks", 0.03, 0.15},
    {"triangle-edges", "Baldwin-Weber", "float", 1, "double_hits", 0.5, 0.9},
    {"triangle-thin", "Baldwin-Weber", "float", 1e6, "ulps_max", 0, 16},
    {"triangle-edges", "Quilez", "float", 1, "leaks", 0.02, 0.2},
    // Whole numbers: double is exact, and still a transformation of each triangle's own leaks.
    {"triangle-grid", "Moeller-Trumbore", "float", 2048, "leaks", 0.01, 0.1},
    {"triangle-grid", "Moeller-Trumbore", "double", 2048, "leaks", 0, 0},
    {"triangle-grid", "Moeller-Trumbore", "double", 2048, "double_hits", 1, 1},
    {"triangle-grid", "Moeller-Trumbore strict", "double", 2048, "leaks", 0.9, 1},
    {"triangle-grid", "Baldwin-Weber", "double", 2048, "leaks", 0.005, 0.1},
    {"triangle-grid", "Quilez", "double", 2048, "leaks", 0, 0},
    {"triangle-grid", "watertight", "float", 8192, "leaks", 0, 0},
    {"triangle-grid", "dioptre", "float", 8192, "leaks", 0, 0},
    {"triangle-grid", "dioptre", "double", 32, "leaks", 0, 0},
    // Boxes.
    {"box-touch", "NaN misses", "float", 10, "false_misses", 0.1, 0.6},
    {"box-touch", "NaN drops out", "float", 10, "false_misses", 0.01, 0.2},
    {"box-touch", "NaN drops out", "float", 2, "false_misses", 0, 0},
    {"box-touch", "far(1+2g3)", "float", 10, "false_misses", 0, 0},
    {"box-touch", "dioptre", "float", 10, "false_misses", 0, 0},
    {"box-touch", "dioptre", "double", 10, "false_misses", 0, 0},
    {"box-flat", "NaN drops out", "float", 10, "false_misses", 0.01, 0.3},
    {"box-flat", "far(1+2g3)", "double", 10, "false_misses", 0, 0},
    {"box-touch", "Quilez", "float", 10, "false_misses", 0.1, 0.5},
    {"cube-edges", "Quilez", "float", 1, "leaks", 0, 0},
    {"cube-edges", "six quads", "float", 1, "leaks", 2e-4, 0.02},
    {"cube-edges", "six quads", "float", 1, "double_hits", 0.5, 1},
    {"cube-edges", "slabs", "float", 1, "leaks", 0, 0},
    {"cube-edges", "slabs", "float", 1, "double_hits", 0, 0},
    {"cube-edges", "dioptre", "float", 1, "leaks", 0, 0},
    // The shapes of shaders: their short formulas lose what is far away, a start near the shape
    // does not.
    {"disk-distance", "Quilez", "float", 1e4, "ulps_p999", 0, 16},
    {"disk-distance", "dioptre", "float", 1e4, "ulps_max", 0, 2},
    {"disk-distance", "dioptre", "float", 1e4, "false_misses", 0, 0},
    {"cone-distance", "Quilez", "float", 1e3, "false_misses", 0.05, 0.5},
    {"cone-distance", "Quilez from near", "float", 1e3, "false_misses", 0, 5e-3},
    {"cone-distance", "Quilez from near", "float", 1e4, "ulps_p999", 0, 16},
    {"ellipsoid-distance", "Quilez", "float", 1e4, "false_hits", 0.3, 1},
    {"ellipsoid-distance", "Quilez from near", "float", 1e4, "ulps_p999", 0, 16},
    {"torus-distance", "Quilez", "float", 10, "ulps_median", 500, ANY_VALUE},
    {"torus-distance", "Quilez", "float", 100, "false_misses", 0.2, 1},
    {"torus-distance", "Quilez", "double", 1e4, "false_misses", 0.2, 1},
    {"torus-distance", "Quilez from near", "float", 1e4, "ulps_p999", 0, 64},
    {"torus-distance", "Quilez from near", "double", 1e4, "false_misses", 0, 5e-3},
    {"capsule-distance", "Quilez", "float", 1e3, "false_misses", 0.3, 0.9},
    {"capsule-distance", "Quilez from near", "float", 1e3, "ulps_p999", 0, 16},
    // Leaving a surface: one constant is wrong in both directions.
    {"mirror-scale", "no offset", "float", 1, "wrong", 0.2, 0.7},
    {"mirror-scale", "t > 1e-4", "float", 1, "wrong", 0, 0},
    {"mirror-scale", "t > 1e-4", "float", 1e3, "wrong", 0.1, 0.7},
    {"mirror-scale", "1e-4 N", "float", 1e-6, "error_median", 10, ANY_VALUE},
    {"mirror-scale", "256 ulps", "float", 1e-6, "error_median", 1, ANY_VALUE},
    {"mirror-scale", "32 u (|P| + R) N", "float", 1e6, "wrong", 0, 0},
    {"mirror-scale", "dioptre", "float", 1e-6, "wrong", 0, 0},
    {"mirror-scale", "dioptre", "float", 1e6, "wrong", 0, 0},
    {"mirror-scale", "dioptre", "float", 1e-6, "error_max", 0, 1e-5},
    {"mirror-world", "t > 1e-4", "float", 1e5, "wrong", 0.2, 0.7},
    {"mirror-world", "dioptre", "float", 1e5, "wrong", 0, 0},
    {"glass-scale", "1e-4 N outwards", "float", 1, "wrong", 1, 1},
    {"glass-scale", "1e-4 N", "float", 1, "wrong", 0, 0},
    {"glass-scale", "1e-4 N", "float", 1e-3, "wrong", 0.9, 1},
    {"glass-scale", "dioptre", "float", 1e-6, "wrong", 0, 0},
    {"glass-scale", "dioptre", "double", 1e6, "wrong", 0, 0},
    {"glass-world", "1e-4 N", "float", 1e4, "wrong", 0.2, 1},
    {"glass-world", "32 u (|P| + R) N", "float", 1e5, "wrong", 0.9, 1},
    {"glass-world", "dioptre", "float", 1e5, "wrong", 0, 0},
    // A cornea, 4e-5 thick: a constant offset loses its inner side.
    {"shells-gap", "t > 1e-4", "double", 4e-5, "work", 2, 2},
    {"shells-gap", "1e-4 N", "double", 4e-5, "work", 2, 2},
    {"shells-gap", "1e-4 N", "double", 1e-2, "wrong", 0, 0},
    {"shells-gap", "256 ulps", "float", 4e-5, "leaks", 0.1, 0.6},
    {"shells-gap", "256 ulps", "double", 4e-5, "leaks", 0, 0},
    {"shells-gap", "no offset", "double", 4e-5, "double_hits", 0.5, 0.9},
    {"shells-gap", "32 u (|P| + R) N", "float", 4e-5, "wrong", 0, 0},
    {"shells-gap", "dioptre", "float", 4e-5, "wrong", 0, 0},
    {"shells-gap", "dioptre", "float", 1e-5, "work", 0, 0},
    {"shells-gap", "dioptre", "double", 1e-6, "wrong", 0, 0},
    // Reflections and Fresnel.
    {"mirror-bounces", "normalized", "float", 10, "error_median", 5e-5, 5e-3},
    {"mirror-bounces", "normalized", "double", 10, "error_median", 0, 1e-11},
    {"mirror-bounces", "dioptre", "float", 10, "error_median", 0, 5e-3},
    {"mirror-bounces", "dioptre", "double", 10, "error_median", 0, 1e-11},
    {"fresnel-into", "one polarisation", "float", 12, "error_max", 0.14, 0.16},
    {"fresnel-into", "Schlick", "float", 5, "error_max", 0.03, 0.04},
    {"fresnel-into", "exact", "float", 90, "error_max", 0, 2.1e-7},
    {"fresnel-into", "exact", "double", 5, "error_max", 0, 4.4e-16},
    {"fresnel-into", "exact", "double", 0.1, "error_max", 0, 6e-16},
    {"fresnel-into", "exact by both shares", "double", 0.1, "error_max", 0, 4.4e-16},
    {"fresnel-into", "exact by both shares", "double", 90, "error_max", 0, 4.4e-16},
    {"fresnel-into", "exact by both shares", "float", 0.1, "error_max", 0, 2.1e-7},
    {"fresnel-into", "dioptre", "float", 0.1, "error_max", 0, 3e-7},
    {"fresnel-into", "dioptre", "double", 0.1, "error_max", 0, 6e-16},
    {"fresnel-out", "Schlick by the inner cosine", "double", 0.03, "error_max", 0.7, 1},
    {"fresnel-out", "exact", "float", 1, "error_max", 0, 1e-5},
    // A thousandth of a texel of 4096 rows: 7.7e-7 radians.
    {"sphere-pole", "acos", "float", 1e-5, "nan", 0.1, 0.7},
    {"sphere-pole", "acos held", "float", 1e-4, "error_p999", 1e-4, ANY_VALUE},
    {"sphere-pole", "atan2", "float", 1e-4, "error_max", 0, 2.5e-7},
    {"sphere-pole", "dioptre", "float", 1, "error_max", 0, 7.7e-7},
    {"sphere-pole", "dioptre", "float", 1e-7, "nan", 0, 0},
    // Fields.
    {"field-normal", "forward", "float", 1e-3, "error_max", 5e-4, 1e-3},
    {"field-normal", "tetrahedral", "float", 1e-2, "error_max", 3e-3, 1e-2},
    {"field-normal", "central", "float", 1e-2, "error_max", 0, 3e-5},
    {"field-normal", "central", "double", 1e-5, "error_max", 0, 1e-10},
    {"field-normal", "central", "float", 1e-6, "error_max", 0.01, ANY_VALUE},
    {"field-normal", "exact", "float", 1e-3, "error_max", 0, 1e-7},
    {"field-normal", "dioptre", "float", 1e-3, "error_max", 0, 3e-5},
    {"field-normal", "dioptre", "double", 1e-3, "error_max", 0, 1e-10},
    {"field-cells", "own cell", "float", 0.1, "wrong", 0.1, 0.25},
    {"field-cells", "27 cells", "float", 0.1, "wrong", 0, 0.005},
    {"marching-angle", "plain", "double", 1, "work", 500, 550},
    {"marching-angle", "relaxed", "double", 1, "work", 300, 350},
    {"marching-angle", "relaxed", "float", 1, "error_max", 0, 5.8e-3},
    {"marching-angle", "plain", "float", 0.1, "false_misses", 0, 0},
    // At most the tolerance divided by the sine.
    {"marching-angle", "dioptre", "float", 1, "error_max", 0, 5.8e-3},
    {"marching-angle", "dioptre", "double", 0.1, "error_max", 0, 5.8e-2},
    {"marching-angle", "dioptre", "float", 0.1, "false_misses", 0, 0},
};

/** @return The quantity of a column of the CSV. */
static const Metric *find_metric(const char *column) {
    for (size_t i = 0; i < METRIC_COUNT; i++) {
        if (strcmp(metric_at(i)->column, column) == 0) {
            return metric_at(i);
        }
    }
    fail_msg("there is no figure %s", column);
    return NULL;
}

/** Runs an experiment with fewer samples. @param[out] results To be released. */
static void run_small_experiment(const Experiment *experiment, int threads,
                                 ExperimentResults *results) {
    Error error = {0};
    Experiment small = *experiment;
    small.sample_count =
        small.sample_count < EXPERIMENT_SAMPLES ? small.sample_count : EXPERIMENT_SAMPLES;
    assert_true(experiment_run(&small, threads, NULL, results, &error));
}

/** Checks an expectation. */
static void check_expectation(const Expectation *row, const Experiment *experiment,
                              const ExperimentResults *results) {
    const MethodResult *result =
        experiment_results_find(results, row->method, row->type, row->level);
    if (!result) {
        fail_msg("%s: nothing of %s in %s at %g", row->experiment, row->method, row->type,
                 row->level);
    }
    double found = find_metric(row->metric)->value(experiment, result);
    if (!(found >= row->low && found <= row->high)) {
        fail_msg("%s: %s in %s at %g: %s %g, not from %g to %g", row->experiment, row->method,
                 row->type, row->level, row->metric, found, row->low, row->high);
    }
}

/** All expectations hold. */
static void test_cliffs(void **state) {
    (void)state;
    for (const Experiment *const *e = experiment_list(); *e; e++) {
        ExperimentResults results;
        size_t rows = 0;
        run_small_experiment(*e, 2, &results);
        for (size_t i = 0; i < sizeof expectations / sizeof *expectations; i++) {
            if (strcmp(expectations[i].experiment, (*e)->name) == 0) {
                check_expectation(&expectations[i], *e, &results);
                rows++;
            }
        }
        if (rows == 0) {
            fail_msg("nothing is expected of %s", (*e)->name);
        }
        experiment_results_deinit(&results);
    }
}

/** Every expectation names an experiment. */
static void test_expectations_are_used(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof expectations / sizeof *expectations; i++) {
        const Experiment *const *e = experiment_list();
        while (*e && strcmp((*e)->name, expectations[i].experiment) != 0) {
            e++;
        }
        assert_non_null(*e);
    }
}

/** Every method is run by an experiment, and its name is valid in a CSV. */
static void test_methods_are_run(void **state) {
    (void)state;
    for (const MethodFamily *const *f = number_types()[0]->families; *f; f++) {
        const Experiment *const *e = experiment_list();
        while (*e && strcmp((*e)->family, (*f)->name) != 0) {
            e++;
        }
        assert_non_null(*e);
        assert_true((*f)->input_count <= METHOD_NUMBERS_MAXIMUM);
        assert_true((*f)->output_count <= METHOD_NUMBERS_MAXIMUM);
        assert_true((size_t)(*f)->input_count * (*e)->queries_per_sample <= SAMPLE_NUMBERS_MAXIMUM);
        for (const Method *m = (*f)->methods; m->name; m++) {
            assert_null(strpbrk(m->name, ",\"\n"));
        }
    }
}

/** One thread and two have the same results. */
static void test_same_metrics(void **state) {
    (void)state;
    ExperimentResults one, two;
    run_small_experiment(&sphere_offset_experiment, 1, &one);
    run_small_experiment(&sphere_offset_experiment, 2, &two);
    size_t count = one.method_count * one.type_count * one.level_count;
    for (size_t i = 0; i < count; i++) {
        const MethodResult *a = &one.rows[i], *b = &two.rows[i];
        assert_int_equal(a->sample_count, b->sample_count);
        assert_memory_equal(&a->median, &b->median, sizeof a->median);
        assert_memory_equal(&a->maximum, &b->maximum, sizeof a->maximum);
        assert_memory_equal(a->outcome_fractions, b->outcome_fractions,
                            sizeof a->outcome_fractions);
    }
    experiment_results_deinit(&one);
    experiment_results_deinit(&two);
}

/** A stopped experiment has no results and an error. */
static void test_stops(void **state) {
    (void)state;
    Error error = {0};
    ExperimentResults results;
    atomic_bool stop = true;
    assert_false(experiment_run(&triangle_edges_experiment, 2, &stop, &results, &error));
    assert_int_equal(error.status, STATUS_INTERRUPTED);
    assert_null(results.rows);
}

/** Quantiles, fractions and means. */
static void test_score(void **state) {
    (void)state;
    ScoreStats score = {0};
    assert_true(isnan(score_quantile(&score, 0.5)));
    for (int i = 100; i >= 0; i--) {
        score_error(&score, i);
    }
    assert_true(score_quantile(&score, 0) == 0);
    assert_true(score_quantile(&score, 0.5) == 50);
    assert_true(score_quantile(&score, 0.999) == 100);
    assert_true(score_quantile(&score, 1) == 100);
    score_distance(&score, QUAD_NO_HIT, 1);
    score_distance(&score, 1, 1);
    score_distance(&score, 1, QUAD_NO_HIT);
    assert_true(score_fraction(&score, OUTCOME_FALSE_MISS) == 0.5);
    assert_true(score_fraction(&score, OUTCOME_FALSE_HIT) == 1);
    assert_true(isnan(score_fraction(&score, OUTCOME_LEAK)));
    score_deinit(&score);
}

/** A sample that fails twice is one failure, and a double hit is one as well as a leak. */
static void test_failures(void **state) {
    (void)state;
    ScoreStats score = {0};
    assert_true(isnan(score_failure_fraction(&score)));
    const bool leaks[4] = {true, false, false, true}, doubles[4] = {false, false, true, true};
    for (int i = 0; i < 4; i++) {
        score_outcome(&score, OUTCOME_LEAK, leaks[i]);
        score_outcome(&score, OUTCOME_DOUBLE_HIT, doubles[i]);
        score_end_sample(&score);
    }
    assert_true(score_failure_fraction(&score) == 0.75);
}

/** Costs whose quartiles overlap are ties; a smaller error then wins. */
static void test_pareto_ties(void **state) {
    (void)state;
    ParetoPoint points[] = {{.cost = 10, .error = 1, .cost_low = 9, .cost_high = 11},
                            {.cost = 10.5, .error = 1, .cost_low = 10, .cost_high = 12},
                            {.cost = 13, .error = 1, .cost_low = 12.5, .cost_high = 14},
                            {.cost = 20, .error = 0.1, .cost_low = 19, .cost_high = 22},
                            {.cost = 19, .error = 0.2, .cost_low = 18, .cost_high = 20}};
    const bool front[] = {true, true, false, true, false},
               tied[] = {false, true, false, false, false};
    pareto_front_find(points, 5, 1);
    for (int i = 0; i < 5; i++) {
        assert_int_equal(points[i].is_pareto, front[i]);
        assert_int_equal(points[i].is_tied, tied[i]);
    }
    for (int i = 0; i < 5; i++) { // Without quartiles there are no ties.
        points[i].cost_low = points[i].cost_high = 0;
    }
    pareto_front_find(points, 5, 1);
    assert_false(points[1].is_pareto);
    assert_true(points[4].is_pareto);
}

/** Columns are as wide as necessary, text left, numbers right. */
static void test_table(void **state) {
    (void)state;
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    Table table = table_make(2, 1);
    table_cell(&table, "who");
    table_cell(&table, "x");
    table_cell(&table, "a");
    table_number(&table, 1234.5);
    table_cell(&table, "b");
    table_number(&table, (double)NAN);
    table_print(&table, stream);
    fclose(stream);
    assert_string_equal(text, "who         x\na    1.23e+03\nb           -\n");
    table_deinit(&table);
    free(text);
}

/** Roots and angles in quad. */
static void test_quad(void **state) {
    (void)state;
    Quadruple root = quad_sqrt(2);
    double error = (double)(root * root - 2);
    assert_true(fabs(error) < 1e-30);
    assert_true(quad_sqrt(0) == 0);
    Quadruple negative = quad_sqrt(-1);
    assert_true(negative != negative);
    assert_true((double)quad_atan2(1, 1) == atan2(1, 1));
}

/** Runs the tests. @return Number of failed tests. */
int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cliffs),          cmocka_unit_test(test_expectations_are_used),
        cmocka_unit_test(test_methods_are_run), cmocka_unit_test(test_same_metrics),
        cmocka_unit_test(test_stops),           cmocka_unit_test(test_score),
        cmocka_unit_test(test_failures),        cmocka_unit_test(test_pareto_ties),
        cmocka_unit_test(test_table),           cmocka_unit_test(test_quad),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
