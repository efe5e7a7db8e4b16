/**
 * @file
 * @brief The right word for a wrong one.
 */
#include "script/suggest.h"

#include <ctype.h>
#include <libintl.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

/** Slips of the pen that make one beginning of a word into one of another; by both lengths. */
typedef size_t Slips[SUGGEST_LENGTH_MAXIMUM + 1][SUGGEST_LENGTH_MAXIMUM + 1];

/** @return Whether two letters are the same, large or small. @param a A letter. @param b One. */
static bool is_same(char a, char b) {
    return tolower((unsigned char)a) == tolower((unsigned char)b);
}

/** @return The smaller of two numbers. @param a A number. @param b Another. */
static size_t smaller(size_t a, size_t b) {
    return a < b ? a : b;
}

/**
 * @return The slips between the first i letters of a and the first j of b, at least 1 each, by
 *         those of shorter beginnings.
 * @param slips  Those of shorter beginnings.
 * @param a      A word.
 * @param i      How many letters of it.
 * @param b      Another.
 * @param j      How many letters of that.
 */
static size_t count_slips(Slips slips, const char *a, size_t i, const char *b, size_t j) {
    size_t wrong = slips[i - 1][j - 1] + !is_same(a[i - 1], b[j - 1]);
    size_t left_out_or_in = smaller(slips[i - 1][j], slips[i][j - 1]) + 1;
    size_t least = smaller(wrong, left_out_or_in);
    bool is_swapped = i > 1 && j > 1 && is_same(a[i - 1], b[j - 2]) && is_same(a[i - 2], b[j - 1]);
    return is_swapped ? smaller(least, slips[i - 2][j - 2] + 1) : least;
}

/**
 * @return How many letters left out, put in, taken for others or swapped with their neighbours lie
 *         between two words (optimal string alignment distance).
 * @param a         A word.
 * @param a_length  Its length, at most SUGGEST_LENGTH_MAXIMUM.
 * @param b         Another.
 * @param b_length  Its length, at most SUGGEST_LENGTH_MAXIMUM.
 */
static size_t distance_of(const char *a, size_t a_length, const char *b, size_t b_length) {
    Slips slips;
    for (size_t i = 0; i <= a_length; i++) {
        for (size_t j = 0; j <= b_length; j++) {
            slips[i][j] = i == 0 ? j : j == 0 ? i : count_slips(slips, a, i, b, j);
        }
    }
    return slips[a_length][b_length];
}

void suggest_try(Suggestion *suggestion, const char *word) {
    size_t wanted = strlen(suggestion->wanted), length = strlen(word);
    if (wanted > SUGGEST_LENGTH_MAXIMUM || length > SUGGEST_LENGTH_MAXIMUM) {
        return;
    }
    // One slip for every three letters: further away, a hint would rather lead astray.
    size_t allowed = (wanted + 2) / 3;
    size_t distance = distance_of(suggestion->wanted, wanted, word, length);
    if (distance > allowed || (suggestion->best && distance > suggestion->distance)) {
        return;
    }
    bool is_nearer = !suggestion->best || distance < suggestion->distance;
    if (is_nearer || strcmp(word, suggestion->best) < 0) {
        suggestion->best = word;
        suggestion->distance = distance;
    }
}

const char *suggest_hint(const Suggestion *suggestion, char hint[SUGGEST_HINT_SIZE]) {
    hint[0] = '\0';
    if (suggestion->best) {
        snprintf(hint, SUGGEST_HINT_SIZE, gettext("; did you mean `%s%s`?"),
                 suggestion->prefix ? suggestion->prefix : "", suggestion->best);
    }
    return hint;
}
