/**
 * @file
 * @brief Words from outside, made safe to show on a terminal.
 */
#ifndef DIOPTRE_SCRIPT_SANITIZE_H
#define DIOPTRE_SCRIPT_SANITIZE_H

#include <stddef.h>

/**
 * Bytes that a path may take in a message, with its final zero. A longer one is shown by its end:
 * the sentence after it must still fit in an Error.
 */
enum { SANITIZED_PATH_SIZE = 768 };

/**
 * Copies text; what is neither printable UTF-8 nor a newline nor a tab becomes `\27` and the like,
 * as in Lua. So no scene can move the cursor or colour the terminal of who reads its errors.
 * @param[out] out  The copy, ended by a zero; cut between characters when it is too long.
 * @param size  Bytes that fit, at least 1.
 */
void sanitize_text(char *out, size_t size, const char *text, size_t length);

/** Copies a path for a message: clean, and by its end where it is very long. */
void sanitize_path(char out[SANITIZED_PATH_SIZE], const char *path);

#endif
