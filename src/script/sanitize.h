/**
 * @file
 * @brief Paths in messages about scenes.
 */
#ifndef DIOPTRE_SCRIPT_SANITIZE_H
#define DIOPTRE_SCRIPT_SANITIZE_H

#include "base/sanitize.h"

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

#endif
