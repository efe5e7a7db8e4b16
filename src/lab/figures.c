/**
 * @file
 * @brief The kinds of figures that experiments find.
 */
#include "lab/figures.h"

#include "dioptre/language.h"

#include <math.h>

/** @return The median error. @param experiment Not looked at. @param finding What was found. */
static double median(const Experiment *experiment, const Finding *finding) {
    (void)experiment;
    return finding->median;
}

/** @return The error that one in a thousand exceeds. @param experiment Not looked at.
 *  @param finding What was found. */
static double p999(const Experiment *experiment, const Finding *finding) {
    (void)experiment;
    return finding->p999;
}

/** @return The largest error. @param experiment Not looked at. @param finding What was found. */
static double maximum(const Experiment *experiment, const Finding *finding) {
    (void)experiment;
    return finding->maximum;
}

/** @return An error in ulps of the number type; NaN where errors are not relative.
 *  @param experiment The experiment. @param finding What was found. @param error The error. */
static double in_ulps(const Experiment *experiment, const Finding *finding, double error) {
    return experiment->is_relative ? ldexp(error, finding->mantissa_bits - 1) : (double)NAN;
}

/** @return The median error, ulps. @param experiment The experiment. @param finding It. */
static double median_ulps(const Experiment *experiment, const Finding *finding) {
    return in_ulps(experiment, finding, finding->median);
}

/** @return The error that one in a thousand exceeds, ulps. @param experiment The experiment.
 *  @param finding What was found. */
static double p999_ulps(const Experiment *experiment, const Finding *finding) {
    return in_ulps(experiment, finding, finding->p999);
}

/** @return The largest error, ulps. @param experiment The experiment. @param finding It. */
static double maximum_ulps(const Experiment *experiment, const Finding *finding) {
    return in_ulps(experiment, finding, finding->maximum);
}

/** @return The share of false hits. @param experiment Not looked at. @param finding It. */
static double false_hits(const Experiment *experiment, const Finding *finding) {
    (void)experiment;
    return finding->shares[OUTCOME_FALSE_HIT];
}

/** @return The share of false misses. @param experiment Not looked at. @param finding It. */
static double false_misses(const Experiment *experiment, const Finding *finding) {
    (void)experiment;
    return finding->shares[OUTCOME_FALSE_MISS];
}

/** @return The share of leaks. @param experiment Not looked at. @param finding It. */
static double leaks(const Experiment *experiment, const Finding *finding) {
    (void)experiment;
    return finding->shares[OUTCOME_LEAK];
}

/** @return The share of double hits. @param experiment Not looked at. @param finding It. */
static double double_hits(const Experiment *experiment, const Finding *finding) {
    (void)experiment;
    return finding->shares[OUTCOME_DOUBLE_HIT];
}

/** @return The share of wrong surfaces. @param experiment Not looked at. @param finding It. */
static double wrong(const Experiment *experiment, const Finding *finding) {
    (void)experiment;
    return finding->shares[OUTCOME_WRONG];
}

/** @return The share of answers that are no number. @param experiment Not looked at.
 *  @param finding What was found. */
static double not_numbers(const Experiment *experiment, const Finding *finding) {
    (void)experiment;
    return finding->shares[OUTCOME_NAN];
}

/** @return The mean cost. @param experiment Not looked at. @param finding What was found. */
static double work(const Experiment *experiment, const Finding *finding) {
    (void)experiment;
    return finding->work;
}

const Figure *figure_at(size_t place) {
    static const Figure figures[FIGURE_COUNT] = {
        {"error_median", N_("median"), FIGURE_ERROR, false, median},
        {"error_p999", N_("one in a thousand is worse"), FIGURE_ERROR, false, p999},
        {"error_max", N_("worst"), FIGURE_ERROR, true, maximum},
        {"ulps_median", N_("median"), FIGURE_ULPS, false, median_ulps},
        {"ulps_p999", N_("one in a thousand is worse"), FIGURE_ULPS, false, p999_ulps},
        {"ulps_max", N_("worst"), FIGURE_ULPS, false, maximum_ulps},
        {"false_hits", N_("false hits"), FIGURE_SHARE, true, false_hits},
        {"false_misses", N_("false misses"), FIGURE_SHARE, true, false_misses},
        {"leaks", N_("leaks"), FIGURE_SHARE, true, leaks},
        {"double_hits", N_("double hits"), FIGURE_SHARE, true, double_hits},
        {"wrong", N_("wrong surface"), FIGURE_SHARE, true, wrong},
        {"nan", N_("not a number"), FIGURE_SHARE, true, not_numbers},
        {"work", N_("mean"), FIGURE_WORK, true, work}};
    return &figures[place];
}

bool figure_is_found(const Figure *figure, const Experiment *experiment, const Findings *findings) {
    size_t count = findings->method_count * findings->type_count * findings->level_count;
    for (size_t i = 0; i < count; i++) {
        if (findings->rows[i].cases > 0 && figure->of(experiment, &findings->rows[i]) > 0) {
            return true;
        }
    }
    return false;
}
