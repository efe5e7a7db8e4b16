/**
 * @file
 * @brief Text files that are there whole or not at all.
 */
#ifndef DIOPTRE_BASE_TEXT_FILE_H
#define DIOPTRE_BASE_TEXT_FILE_H

#include "base/error.h"

#include <stddef.h>

/**
 * Writes a text file, never over another one.
 * @param[out] exists  Whether it was not written because there is such a file.
 * @return Whether it is there, all of it.
 */
bool text_file_write_new(const char *path, const char *text, size_t size, bool *exists,
                         Error *error);

#endif
