/**
 * @file
 * @brief The right word for a wrong one.
 */
#include "base/suggest.h"

#include <ctype.h>
#include <libintl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/** Slips of the pen that make one beginning of a word into one of another; by both lengths. */
typedef size_t EditDistances[SUGGEST_LENGTH_MAXIMUM + 1][SUGGEST_LENGTH_MAXIMUM + 1];

/** @return Whether two letters are the same, large or small. */
static bool is_same_letter(char a, char b) {
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/** @return The smaller of two numbers. */
static size_t minimum(size_t a, size_t b) {
    return a < b ? a : b;
}

/**
 * @return The slips between the first i letters of a and the first j of b, at least 1 each, by
 *         those of shorter beginnings.
 * @param distances  Those of shorter beginnings.
 * @param i  How many letters of it.
 * @param j  How many letters of that.
 */
static size_t edit_distance_step(EditDistances distances, const char *a, size_t i, const char *b,
                                 size_t j) {
    size_t substituted = distances[i - 1][j - 1] + !is_same_letter(a[i - 1], b[j - 1]);
    size_t inserted_or_deleted = minimum(distances[i - 1][j], distances[i][j - 1]) + 1;
    size_t least = minimum(substituted, inserted_or_deleted);
    bool is_swapped =
        i > 1 && j > 1 && is_same_letter(a[i - 1], b[j - 2]) && is_same_letter(a[i - 2], b[j - 1]);
    return is_swapped ? minimum(least, distances[i - 2][j - 2] + 1) : least;
}

/**
 * @return How many letters left out, put in, taken for others or swapped with their neighbours lie
 *         between two words (optimal string alignment distance).
 * @param a_length  Its length, at most SUGGEST_LENGTH_MAXIMUM.
 * @param b_length  Its length, at most SUGGEST_LENGTH_MAXIMUM.
 */
static size_t edit_distance(const char *a, size_t a_length, const char *b, size_t b_length) {
    EditDistances distances;
    for (size_t i = 0; i <= a_length; i++) {
        for (size_t j = 0; j <= b_length; j++) {
            distances[i][j] = i == 0 ? j : j == 0 ? i : edit_distance_step(distances, a, i, b, j);
        }
    }
    return distances[a_length][b_length];
}

void suggest_try(Suggestion *suggestion, const char *candidate) {
    size_t word_length = strlen(suggestion->word), length = strlen(candidate);
    if (word_length > SUGGEST_LENGTH_MAXIMUM || length > SUGGEST_LENGTH_MAXIMUM) {
        return;
    }
    // One slip for every three letters: further away, a hint would rather lead astray.
    size_t distance_maximum = (word_length + 2) / 3;
    size_t distance = edit_distance(suggestion->word, word_length, candidate, length);
    if (distance > distance_maximum ||
        (suggestion->best_match && distance > suggestion->distance)) {
        return;
    }
    bool is_better = !suggestion->best_match || distance < suggestion->distance;
    if (is_better || strcmp(candidate, suggestion->best_match) < 0) {
        suggestion->best_match = candidate;
        suggestion->distance = distance;
    }
}

const char *suggest_hint(const Suggestion *suggestion, char hint[SUGGEST_HINT_SIZE]) {
    hint[0] = '\0';
    if (suggestion->best_match) {
        snprintf(hint, SUGGEST_HINT_SIZE, gettext("; did you mean `%s%s`?"),
                 suggestion->prefix ? suggestion->prefix : "", suggestion->best_match);
    }
    return hint;
}
