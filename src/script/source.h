/**
 * @file
 * @brief The text of a scene file.
 */
#ifndef SCRIPT_SOURCE_H
#define SCRIPT_SOURCE_H

#include "dioptre/error.h"

#include <stddef.h>

/** Longest scene file, bytes: more than anybody writes, less than would be felt. */
#define SOURCE_MAXIMUM ((size_t)16 << 20)

/** A file that was read whole. */
typedef struct Source {
    char *text;  /**< Its bytes; owned. */
    size_t size; /**< How many. */
} Source;

/**
 * Reads a file. Only a regular file is opened, so that no FIFO or device can keep the program
 * waiting.
 * @param[out] source  The file; give it back with #source_release.
 * @param path         Where it is; `-` reads standard input to its end.
 * @param[out] error   What is wrong, without the path.
 * @return false if it cannot be read, or is longer than #SOURCE_MAXIMUM.
 */
bool source_read(Source *source, const char *path, Error *error);

/**
 * Says whether a file holds text, as against compiled Lua, a picture, or text in UTF-16.
 * @param source      The file.
 * @param[out] line   Where it does not, from 1; may be NULL.
 * @param[out] error  What is wrong, without path and line.
 * @return Whether it does.
 */
bool source_check_text(const Source *source, int *line, Error *error);

/**
 * Finds the Lua text in a file: after the mark that Windows puts before UTF-8, and after a first
 * line for the shell (`#!/usr/bin/dioptre`), whose end stays so that lines keep their numbers.
 * @param source     The file.
 * @param[out] size  Bytes of it.
 * @return The text, not ended by a zero; owned by the source.
 */
const char *source_text(const Source *source, size_t *size);

/** Gives a file's text back. @param source What #source_read filled. */
void source_release(Source *source);

#endif
