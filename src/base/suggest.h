/**
 * @file
 * @brief Search for the known word nearest to a misspelt one.
 */
#ifndef DIOPTRE_BASE_SUGGEST_H
#define DIOPTRE_BASE_SUGGEST_H

#include <stddef.h>

/** Largest length of a compared word, bytes; all words of the scene language are shorter. */
enum { SUGGEST_LENGTH_MAXIMUM = 32 };

/** Size of a hint, with its final zero. */
enum { SUGGEST_HINT_SIZE = 2 * SUGGEST_LENGTH_MAXIMUM + 64 };

/** A search for the nearest known word. Initialised to `{.word = word}`. */
typedef struct Suggestion {
    const char *prefix;     /**< Text before the known word in the hint; NULL: none. */
    const char *word;       /**< The misspelt word. */
    const char *best_match; /**< The nearest known word so far; NULL: none is near. */
    size_t distance;        /**< Edit distance of the two. */
} Suggestion;

/**
 * Compares one known word. Of two equally near, the first in alphabetical order is kept.
 * @param suggestion  The search.
 * @param candidate   The known word; must live as long as the search.
 */
void suggest_try(Suggestion *suggestion, const char *candidate);

/**
 * Formats the result of a search.
 * @param suggestion  The search.
 * @param[out] hint   Such as `` ; did you mean `sphere`? ``, or an empty string.
 * @return The hint.
 */
const char *suggest_hint(const Suggestion *suggestion, char hint[SUGGEST_HINT_SIZE]);

#endif
