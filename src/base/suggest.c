/**
 * @file
 * @brief Search for the known word nearest to a misspelt one.
 */
#include "base/suggest.h"

#include <ctype.h>
#include <libintl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/** Shortest word that may be an abbreviation, bytes. */
enum { ABBREVIATION_MINIMUM = 2 };

/** Edit distances of all pairs of prefixes of two words, by their lengths. */
typedef size_t EditDistances[SUGGEST_LENGTH_MAXIMUM + 1][SUGGEST_LENGTH_MAXIMUM + 1];

/** @return Whether two letters are equal, ignoring case. */
static bool is_same_letter(char a, char b) {
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/** @return The smaller of two numbers. */
static size_t minimum(size_t a, size_t b) {
    return a < b ? a : b;
}

/**
 * @return Edit distance of the first i letters of a and the first j of b, at least 1 each, by those
 *         of shorter prefixes.
 * @param distances  Edit distances of shorter prefixes.
 * @param a          A word.
 * @param i          Length of its prefix.
 * @param b          The other word.
 * @param j          Length of its prefix.
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
 * @return Edit distance of two words: number of insertions, deletions, substitutions and swaps of
 *         neighbours (optimal string alignment distance).
 * @param a         A word.
 * @param a_length  Its length, at most #SUGGEST_LENGTH_MAXIMUM.
 * @param b         The other word.
 * @param b_length  Its length, at most #SUGGEST_LENGTH_MAXIMUM.
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
    // At most one edit per three letters: more distant words would be misleading.
    size_t distance_maximum = (word_length + 2) / 3;
    size_t distance = edit_distance(suggestion->word, word_length, candidate, length);
    // An abbreviation counts as the most distant word that is not misleading.
    if (word_length >= ABBREVIATION_MINIMUM &&
        strncmp(suggestion->word, candidate, word_length) == 0 && distance > distance_maximum) {
        distance = distance_maximum;
    }
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
