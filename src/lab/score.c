/**
 * @file
 * @brief What comes of asking a method many questions.
 */
#include "lab/score.h"

#include <math.h>
#include <stdlib.h>

void score_error(Score *score, Quadruple error) {
    if (score->count == score->capacity) {
        size_t capacity = score->capacity ? 2 * score->capacity : 1024;
        double *errors = realloc(score->errors, capacity * sizeof *errors);
        if (!errors) {
            score->is_full = true;
            return;
        }
        score->errors = errors;
        score->capacity = capacity;
    }
    score->errors[score->count++] = (double)error;
}

void score_outcome(Score *score, Outcome outcome, bool happened) {
    score->cases[outcome]++;
    score->counts[outcome] += happened;
}

void score_work(Score *score, Quadruple work) {
    score->work += (double)work;
    score->worked++;
}

void score_distance(Score *score, Quadruple distance, Quadruple truth) {
    bool is_hit = distance < QUAD_NONE, is_there = truth < QUAD_NONE;
    score_outcome(score, is_there ? OUTCOME_FALSE_MISS : OUTCOME_FALSE_HIT, is_hit != is_there);
    if (is_hit && is_there) {
        score_error(score, quad_abs(distance - truth) / quad_abs(truth));
    }
}

/** @return Order of two numbers, for qsort. @param a One. @param b The other. */
static int compare(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double score_quantile(Score *score, double share) {
    if (score->count == 0) {
        return NAN;
    }
    qsort(score->errors, score->count, sizeof *score->errors, compare);
    return score->errors[(size_t)ceil(share * (double)(score->count - 1))];
}

double score_share(const Score *score, Outcome outcome) {
    return score->cases[outcome] ? (double)score->counts[outcome] / (double)score->cases[outcome]
                                 : (double)NAN;
}

void score_release(Score *score) {
    free(score->errors);
    *score = (Score){0};
}
