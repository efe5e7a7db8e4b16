/**
 * @file
 * @brief The right word for a wrong one.
 */
#ifndef DIOPTRE_BASE_SUGGEST_H
#define DIOPTRE_BASE_SUGGEST_H

#include <stddef.h>

/** Longest word that is compared, bytes; longer than any of the scene language. */
enum { SUGGEST_LENGTH_MAXIMUM = 32 };

/** Bytes that a hint takes, with its final zero. */
enum { SUGGEST_HINT_SIZE = 2 * SUGGEST_LENGTH_MAXIMUM + 64 };

/** A search for the right word. Begins as `{.wanted = word}`. */
typedef struct Suggestion {
    const char *prefix;     /**< What stands before the right words in the hint; NULL: nothing. */
    const char *word;       /**< The wrong word. */
    const char *best_match; /**< The right word that is nearest to it so far; NULL: none is near. */
    size_t distance;        /**< How many slips of the pen they are apart. */
} Suggestion;

/** Compares one more right word. Of two that are as near, the first of the alphabet wins. @param
 *  candidate The right word; must live as long as the search. */
void suggest_try(Suggestion *suggestion, const char *candidate);

/**
 * Says what was found.
 * @param[out] hint  Such as `` ; did you mean `sphere`? ``, or nothing.
 * @return The hint.
 */
const char *suggest_hint(const Suggestion *suggestion, char hint[SUGGEST_HINT_SIZE]);

#endif
