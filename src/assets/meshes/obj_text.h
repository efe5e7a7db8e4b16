/**
 * @file
 * @brief The statements, words and numbers of an OBJ text.
 */
#ifndef DIOPTRE_ASSETS_MESHES_OBJ_TEXT_H
#define DIOPTRE_ASSETS_MESHES_OBJ_TEXT_H

#include <stdbool.h>
#include <stddef.h>

/**
 * A position in an OBJ text. Lines end with LF, CR LF or CR. A backslash before the end of a line
 * continues the statement, except in a comment, which goes from `#` to the end of the line.
 */
typedef struct ObjText {
    const char *next; /**< The next character. */
    const char *end;  /**< End of the text. */
    size_t line;      /**< Line of #next, from 1. */
} ObjText;

/** A word of an OBJ text, without a final zero. */
typedef struct ObjWord {
    const char *start; /**< Its first character. */
    size_t length;     /**< Number of bytes. */
} ObjWord;

/**
 * @return The position at the first statement, behind a byte order mark of UTF-8.
 * @param text  The text.
 * @param size  Bytes of the text.
 */
ObjText obj_text_start(const char *text, size_t size);

/** @return Whether the statement has no more words. @param[in,out] text The position, moved to the
 *  next word. */
bool obj_text_is_at_end(ObjText *text);

/** Moves the position behind the end of its statement. @param[in,out] text The position. */
void obj_text_next_statement(ObjText *text);

/**
 * Reads a word.
 * @param[in,out] text  The position, moved behind the word.
 * @return The word; without length at the end of the statement.
 */
ObjWord obj_text_word(ObjText *text);

/**
 * Reads a decimal number, rounded to the nearest double.
 * @param[in,out] text  The position, moved behind the number.
 * @param[out] number   The number; infinite if it is too large for a double.
 * @return false if the next word is not one.
 */
bool obj_text_number(ObjText *text, double *number);

/**
 * Reads an index at the position itself, such as those in `1/-2/3`.
 * @param[in,out] text  The position, moved behind the index.
 * @param[out] index    The index; numbers out of range become the limits of the type.
 * @return false if there is none.
 */
bool obj_text_index(ObjText *text, long long *index);

/** Moves the position behind a `/`. @param[in,out] text The position. @return Whether it is one. */
bool obj_text_slash(ObjText *text);

/** @return Whether a word ends at the position. @param text The position. */
bool obj_text_is_word_end(const ObjText *text);

#endif
