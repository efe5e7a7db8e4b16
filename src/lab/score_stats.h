/**
 * @file
 * @brief What comes of asking a method many questions: errors, and outcomes that ought not to be.
 */
#ifndef DIOPTRE_LAB_SCORE_STATS_H
#define DIOPTRE_LAB_SCORE_STATS_H

#include "lab/vec3q.h"

#include <stddef.h>

/** What may go wrong, and may be counted. */
typedef enum {
    OUTCOME_FALSE_HIT,  /**< It said that there is something where there is nothing. */
    OUTCOME_FALSE_MISS, /**< It said that there is nothing where there is something. */
    OUTCOME_LEAK,       /**< A ray went through what is closed. */
    OUTCOME_DOUBLE_HIT, /**< A ray met one surface twice. */
    OUTCOME_WRONG,      /**< It met a surface that it must not meet, or not the one that it must. */
    OUTCOME_NAN,        /**< The answer was no number. */
    OUTCOME_COUNT       /**< How many kinds there are. */
} Outcome;

/** The errors and outcomes of a method. Begins as `{0}`. */
typedef struct ScoreStats {
    double *errors;                       /**< Those so far; owned. */
    size_t count;                         /**< How many. */
    size_t capacity;                      /**< How many there is room for. */
    size_t outcome_trials[OUTCOME_COUNT]; /**< How often each outcome could have been. */
    size_t outcome_counts[OUTCOME_COUNT]; /**< How often it was. */
    double cost_sum;                      /**< Sum of what the answers cost, such as steps. */
    size_t cost_count;                    /**< How many of them said it. */
    bool is_out_of_memory;                /**< Whether there was no memory for an error. */
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

/** Adds a case of an outcome. @param happened Whether it was so. */
void score_outcome(ScoreStats *score, Outcome outcome, bool happened);

/** Adds what an answer cost. */
void score_cost(ScoreStats *score, Quadruple work);

/** Adds a distance to a score: an error relative to the true one, a false hit, or a false miss.
 *  @param distance It; #QUAD_NO_HIT for a miss. */
void score_distance(ScoreStats *score, Quadruple distance, Quadruple truth);

/**
 * @return The error that a share of them does not exceed; NaN where there is none.
 * @param[in,out] score  The score; its errors are sorted.
 * @param fraction          Such as 0.5 for the median, 1 for the largest.
 */
double score_quantile(ScoreStats *score, double fraction);

/** @return How often an outcome was, 0 to 1; NaN where it could not have been. */
double score_fraction(const ScoreStats *score, Outcome outcome);

/** Gives the errors back. */
void score_deinit(ScoreStats *score);

#endif
