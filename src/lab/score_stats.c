/**
 * @file
 * @brief Scores of a method over many samples.
 */
#include "lab/score_stats.h"

#include <math.h>
#include <stdlib.h>

void score_error(ScoreStats *score, Quadruple error) {
    if (score->count == score->capacity) {
        size_t capacity = score->capacity ? 2 * score->capacity : 1024;
        double *errors = realloc(score->errors, capacity * sizeof *errors);
        if (!errors) {
            score->is_out_of_memory = true;
            return;
        }
        score->errors = errors;
        score->capacity = capacity;
    }
    score->errors[score->count++] = (double)error;
}

void score_outcome(ScoreStats *score, Outcome outcome, bool happened) {
    score->outcome_trials[outcome]++;
    score->outcome_counts[outcome] += happened;
}

void score_end_sample(ScoreStats *score) {
    size_t failures = 0;
    for (int i = 0; i < OUTCOME_COUNT; i++) {
        failures += score->outcome_counts[i];
    }
    score->sample_count++;
    score->failed_count += failures > score->failures_before;
    score->failures_before = failures;
}

double score_failure_fraction(const ScoreStats *score) {
    size_t trials = 0;
    for (int i = 0; i < OUTCOME_COUNT; i++) {
        trials += score->outcome_trials[i];
    }
    return trials ? (double)score->failed_count / (double)score->sample_count : (double)NAN;
}

void score_cost(ScoreStats *score, Quadruple work) {
    score->cost_sum += (double)work;
    score->cost_count++;
}

void score_distance(ScoreStats *score, Quadruple distance, Quadruple truth) {
    bool is_hit = distance < QUAD_NO_HIT, is_there = truth < QUAD_NO_HIT;
    score_outcome(score, is_there ? OUTCOME_FALSE_MISS : OUTCOME_FALSE_HIT, is_hit != is_there);
    if (is_hit && is_there) {
        score_error(score, quad_abs(distance - truth) / quad_abs(truth));
    }
}

/** @return Order of two numbers, for qsort. */
static int compare_numbers(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

Quartiles quartiles_of(double *numbers, size_t count) {
    qsort(numbers, count, sizeof *numbers, compare_numbers);
    return (Quartiles){numbers[count / 4], numbers[count / 2], numbers[count - 1 - count / 4]};
}

double score_quantile(ScoreStats *score, double fraction) {
    if (score->count == 0) {
        return NAN;
    }
    qsort(score->errors, score->count, sizeof *score->errors, compare_numbers);
    return score->errors[(size_t)ceil(fraction * (double)(score->count - 1))];
}

double score_fraction(const ScoreStats *score, Outcome outcome) {
    return score->outcome_trials[outcome]
               ? (double)score->outcome_counts[outcome] / (double)score->outcome_trials[outcome]
               : (double)NAN;
}

void score_deinit(ScoreStats *score) {
    free(score->errors);
    *score = (ScoreStats){0};
}
