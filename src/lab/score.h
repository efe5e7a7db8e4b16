/**
 * @file
 * @brief What comes of asking a method many questions: errors, and outcomes that ought not to be.
 */
#ifndef DIOPTRE_LAB_SCORE_H
#define DIOPTRE_LAB_SCORE_H

#include "lab/quad.h"

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
typedef struct Score {
    double *errors;               /**< Those so far; owned. */
    size_t count;                 /**< How many. */
    size_t capacity;              /**< How many there is room for. */
    size_t cases[OUTCOME_COUNT];  /**< How often each outcome could have been. */
    size_t counts[OUTCOME_COUNT]; /**< How often it was. */
    double work;                  /**< Sum of what the answers cost, such as steps. */
    size_t worked;                /**< How many of them said it. */
    bool is_full;                 /**< Whether there was no memory for an error. */
} Score;

/** Adds an error. @param[in,out] score The score. @param error At least 0. */
void score_error(Score *score, Quadruple error);

/** Adds a case of an outcome. @param[in,out] score The score. @param outcome Which.
 *  @param happened Whether it was so. */
void score_outcome(Score *score, Outcome outcome, bool happened);

/** Adds what an answer cost. @param[in,out] score The score. @param work How much. */
void score_work(Score *score, Quadruple work);

/** Adds a distance to a score: an error relative to the true one, a false hit, or a false miss.
 *  @param[in,out] score The score. @param distance It; #QUAD_NONE for a miss.
 *  @param truth The true one; likewise. */
void score_distance(Score *score, Quadruple distance, Quadruple truth);

/**
 * @return The error that a share of them does not exceed; NaN where there is none.
 * @param[in,out] score  The score; its errors are sorted.
 * @param share          Such as 0.5 for the median, 1 for the largest.
 */
double score_quantile(Score *score, double share);

/** @return How often an outcome was, 0 to 1; NaN where it could not have been. @param score The
 *  score. @param outcome Which. */
double score_share(const Score *score, Outcome outcome);

/** Gives the errors back. @param[in,out] score The score. */
void score_release(Score *score);

#endif
