/**
 * @file
 * @brief Text files that are there whole or not at all.
 */
#ifndef DIOPTRE_BASE_TEXT_FILE_H
#define DIOPTRE_BASE_TEXT_FILE_H

#include "dioptre/error.h"

#include <stddef.h>

/**
 * Writes a text file, never over another one.
 * @param path         Its path.
 * @param text         Its bytes.
 * @param size         How many.
 * @param[out] exists  Whether it was not written because there is such a file.
 * @param[out] error   What is wrong (#STATUS_FAILED).
 * @return Whether it is there, all of it.
 */
bool text_file_write_new(const char *path, const char *text, size_t size, bool *exists,
                         Error *error);

#endif
