/**
 * @file
 * @brief Text files that are written completely or not at all.
 */
#ifndef DIOPTRE_BASE_TEXT_FILE_H
#define DIOPTRE_BASE_TEXT_FILE_H

#include "base/error.h"

#include <stddef.h>

/**
 * Writes a new text file; never replaces another.
 * @param path         Its path.
 * @param text         The text.
 * @param size         Bytes of the text.
 * @param[out] exists  Whether it failed because the file exists.
 * @param[out] error   What is wrong.
 * @return Whether the file is complete.
 */
bool text_file_write_new(const char *path, const char *text, size_t size, bool *exists,
                         Error *error);

#endif
