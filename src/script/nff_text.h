/**
 * @file
 * @brief The words and numbers of an NFF text.
 */
#ifndef DIOPTRE_SCRIPT_NFF_TEXT_H
#define DIOPTRE_SCRIPT_NFF_TEXT_H

#include "base/error.h"

#include <stddef.h>

/** Size of a word, with its final zero; longer ones are cut. No number needs as many digits. */
enum { NFF_WORD_SIZE = 64 };

/** A position in an NFF text. */
typedef struct NffText {
    const char *next; /**< The next character. */
    const char *end;  /**< End of the text. */
    int line;         /**< Line of #next, from 1. */
} NffText;

/**
 * Reads a word. Comments, from `#` to the end of the line, are skipped.
 * @param[in,out] text  The position, moved behind the word.
 * @param[out] word     The word; empty without one.
 * @return Whether there is one.
 */
bool nff_text_word(NffText *text, char word[NFF_WORD_SIZE]);

/** @return Whether the current line has another word. @param[in,out] text The position, moved to
 *  it. */
bool nff_text_has_word_in_line(NffText *text);

/**
 * Reads numbers, on any lines.
 * @param[in,out] text   The position.
 * @param statement      The statement that needs them, for errors.
 * @param count          Number of numbers.
 * @param[out] numbers   The numbers; they may be infinite or NaN.
 * @param[out] error     What is wrong.
 * @return Whether all are there.
 */
bool nff_text_numbers(NffText *text, const char *statement, size_t count, double *numbers,
                      Error *error);

#endif
