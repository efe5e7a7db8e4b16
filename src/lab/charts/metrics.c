/**
 * @file
 * @brief The quantities in the results of experiments.
 */
#include "lab/charts/metrics.h"

#include "base/language.h"

#include <math.h>

/** @return The median error. */
static double median_error(const Experiment *experiment, const MethodResult *result) {
    (void)experiment;
    return result->median;
}

/** @return The error that one in a thousand exceeds. */
static double p999_error(const Experiment *experiment, const MethodResult *result) {
    (void)experiment;
    return result->p999;
}

/** @return The largest error. */
static double maximum_error(const Experiment *experiment, const MethodResult *result) {
    (void)experiment;
    return result->maximum;
}

/** @return An error in ulps of the number type; NaN where errors are not relative. */
static double error_in_ulps(const Experiment *experiment, const MethodResult *result,
                            double error) {
    return experiment->is_relative ? ldexp(error, result->mantissa_bits - 1) : (double)NAN;
}

/** @return The median error, ulps. */
static double median_ulps(const Experiment *experiment, const MethodResult *result) {
    return error_in_ulps(experiment, result, result->median);
}

/** @return The error that one in a thousand exceeds, ulps. */
static double p999_ulps(const Experiment *experiment, const MethodResult *result) {
    return error_in_ulps(experiment, result, result->p999);
}

/** @return The largest error, ulps. */
static double maximum_ulps(const Experiment *experiment, const MethodResult *result) {
    return error_in_ulps(experiment, result, result->maximum);
}

/** @return The fraction of false hits. */
static double false_hit_fraction(const Experiment *experiment, const MethodResult *result) {
    (void)experiment;
    return result->outcome_fractions[OUTCOME_FALSE_HIT];
}

/** @return The fraction of false misses. */
static double false_miss_fraction(const Experiment *experiment, const MethodResult *result) {
    (void)experiment;
    return result->outcome_fractions[OUTCOME_FALSE_MISS];
}

/** @return The fraction of leaks. */
static double leak_fraction(const Experiment *experiment, const MethodResult *result) {
    (void)experiment;
    return result->outcome_fractions[OUTCOME_LEAK];
}

/** @return The fraction of double hits. */
static double double_hit_fraction(const Experiment *experiment, const MethodResult *result) {
    (void)experiment;
    return result->outcome_fractions[OUTCOME_DOUBLE_HIT];
}

/** @return The fraction of wrong surfaces. */
static double wrong_fraction(const Experiment *experiment, const MethodResult *result) {
    (void)experiment;
    return result->outcome_fractions[OUTCOME_WRONG];
}

/** @return The fraction of outputs that are NaN. */
static double nan_fraction(const Experiment *experiment, const MethodResult *result) {
    (void)experiment;
    return result->outcome_fractions[OUTCOME_NAN];
}

/** @return The mean cost. */
static double mean_cost(const Experiment *experiment, const MethodResult *result) {
    (void)experiment;
    return result->mean_cost;
}

const Metric *metric_at(size_t index) {
    static const Metric figures[METRIC_COUNT] = {
        {"error_median", N_("median"), METRIC_ERROR, false, median_error},
        {"error_p999", N_("one in a thousand is worse"), METRIC_ERROR, false, p999_error},
        {"error_max", N_("worst"), METRIC_ERROR, true, maximum_error},
        {"ulps_median", N_("median"), METRIC_ULPS, false, median_ulps},
        {"ulps_p999", N_("one in a thousand is worse"), METRIC_ULPS, false, p999_ulps},
        {"ulps_max", N_("worst"), METRIC_ULPS, false, maximum_ulps},
        {"false_hits", N_("false hits"), METRIC_FRACTION, true, false_hit_fraction},
        {"false_misses", N_("false misses"), METRIC_FRACTION, true, false_miss_fraction},
        {"leaks", N_("leaks"), METRIC_FRACTION, true, leak_fraction},
        {"double_hits", N_("double hits"), METRIC_FRACTION, true, double_hit_fraction},
        {"wrong", N_("wrong surface"), METRIC_FRACTION, true, wrong_fraction},
        {"nan", N_("not a number"), METRIC_FRACTION, true, nan_fraction},
        {"work", N_("mean"), METRIC_COST, true, mean_cost}};
    return &figures[index];
}

bool metric_is_nonzero(const Metric *metric, const Experiment *experiment,
                       const ExperimentResults *results) {
    size_t count = results->method_count * results->type_count * results->level_count;
    for (size_t i = 0; i < count; i++) {
        if (results->rows[i].sample_count > 0 && metric->value(experiment, &results->rows[i]) > 0) {
            return true;
        }
    }
    return false;
}
