/**
 * @file
 * @brief Scores of a method over many samples: errors, and outcomes that are failures.
 */
#ifndef DIOPTRE_LAB_SCORE_STATS_H
#define DIOPTRE_LAB_SCORE_STATS_H

#include "lab/vec3q.h"

#include <stddef.h>

/** Failures that are counted. */
typedef enum {
    OUTCOME_FALSE_HIT,  /**< A hit where there is nothing. */
    OUTCOME_FALSE_MISS, /**< A miss where there is something. */
    OUTCOME_LEAK,       /**< A ray passed through a closed surface. */
    OUTCOME_DOUBLE_HIT, /**< A ray hit one surface twice. */
    OUTCOME_WRONG,      /**< A hit on the wrong surface. */
    OUTCOME_NAN,        /**< The output is NaN. */
    OUTCOME_COUNT       /**< Number of outcomes. */
} Outcome;

/** Scores of a method. Initialized as `{0}`. */
typedef struct ScoreStats {
    double *errors;                       /**< Errors so far; owned. */
    size_t count;                         /**< Number of errors. */
    size_t capacity;                      /**< Errors that fit in. */
    size_t outcome_trials[OUTCOME_COUNT]; /**< Samples in which it was possible. */
    size_t outcome_counts[OUTCOME_COUNT]; /**< Samples in which it happened. */
    size_t sample_count;                  /**< Samples that are finished. */
    size_t failed_count;                  /**< Those with any failure. */
    size_t failures_before;               /**< Failures of all samples that are finished. */
    double cost_sum;                      /**< Sum of costs, such as steps. */
    size_t cost_count;                    /**< Samples with a cost. */
    bool is_out_of_memory;                /**< Whether an error did not fit in memory. */
} ScoreStats;

/** Quartiles of some numbers. */
typedef struct Quartiles {
    double low;    /**< A quarter of them is at most this. */
    double median; /**< Half of them. */
    double high;   /**< Three quarters. */
} Quartiles;

/** @return The quartiles. @param[in,out] numbers At least one; sorted. */
Quartiles quartiles_of(double *numbers, size_t count);

/** Adds an error. */
void score_error(ScoreStats *score, Quadruple error);

/** Adds a sample in which an outcome was possible. */
void score_outcome(ScoreStats *score, Outcome outcome, bool happened);

/** Ends a sample: it has failed if any outcome happened since the one before. */
void score_end_sample(ScoreStats *score);

/** @return The frequency of samples with any failure, a double hit as well as a leak, 0 to 1; NaN:
 *  none was possible. */
double score_failure_fraction(const ScoreStats *score);

/** Adds a cost. */
void score_cost(ScoreStats *score, Quadruple work);

/** Adds a distance: its relative error, a false hit, or a false miss. @param distance
 *  #QUAD_NO_HIT: a miss. */
void score_distance(ScoreStats *score, Quadruple distance, Quadruple truth);

/**
 * @return A quantile of the errors; NaN without errors.
 * @param[in,out] score  Its errors are sorted.
 * @param fraction       Such as 0.5 for the median, 1 for the largest.
 */
double score_quantile(ScoreStats *score, double fraction);

/** @return The frequency of an outcome, 0 to 1; NaN: it was never possible. */
double score_fraction(const ScoreStats *score, Outcome outcome);

/** Releases the errors. */
void score_deinit(ScoreStats *score);

#endif
