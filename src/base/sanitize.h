/**
 * @file
 * @brief Text of strangers, escaped for terminals: file names, and what scenes say.
 */
#ifndef DIOPTRE_BASE_SANITIZE_H
#define DIOPTRE_BASE_SANITIZE_H

#include <stddef.h>
#include <stdio.h>

/**
 * Copies text and escapes all but printable UTF-8, newlines and tabs as `\27`, like Lua, and the
 * characters that change the direction of text. Names and errors of a scene therefore cannot
 * control the user's terminal.
 * @param[out] out  The copy with a final zero; cut between characters if it is too long.
 * @param size      Size of the copy, at least 1.
 * @param text      The text.
 * @param length    Bytes of the text.
 */
void sanitize_text(char *out, size_t size, const char *text, size_t length);

/** Copies a text of one line, such as a file name, like #sanitize_text; newlines and tabs are
 * escaped, too. */
void sanitize_line(char *out, size_t size, const char *text);

/**
 * Size of a sanitized path, with its final zero. A longer path is cut at its start: the sentence
 * after it must fit in an #Error.
 */
enum { SANITIZED_PATH_SIZE = 768 };

/**
 * Copies a path for a message: sanitized as one line, and cut at its start if it is long.
 * @param[out] out  The copy.
 * @param path      The path.
 */
void sanitize_path(char out[SANITIZED_PATH_SIZE], const char *path);

/** Prints a message like #sanitize_text. */
void sanitize_print(const char *text, FILE *stream);

/** Prints a text of one line like #sanitize_line. */
void sanitize_print_line(const char *text, FILE *stream);

#endif
