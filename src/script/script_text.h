/**
 * @file
 * @brief The text of a scene file.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_TEXT_H
#define DIOPTRE_SCRIPT_SCRIPT_TEXT_H

#include "base/error.h"

#include <stddef.h>

/** Largest size of a scene file, bytes. */
#define SCRIPT_TEXT_MAXIMUM ((size_t)16 << 20)

/** Content of a file. */
typedef struct ScriptText {
    char *text;  /**< Its bytes; owned. */
    size_t size; /**< Number of bytes. */
} ScriptText;

/**
 * Reads a file. Only regular files are opened, because FIFOs and devices can block.
 * @param[out] script  The content, to be released with #script_text_deinit.
 * @param path         Its path; `-` reads standard input to its end.
 * @param[out] error   What is wrong, without the path.
 * @return false if it cannot be read, or is longer than #SCRIPT_TEXT_MAXIMUM.
 */
bool script_text_read(ScriptText *script, const char *path, Error *error);

/**
 * Reads an open file to its end.
 * @param[out] script  The content, to be released with #script_text_deinit.
 * @param file         Its descriptor; it stays open.
 * @param[out] error   What is wrong, without the path.
 * @return false if it cannot be read, or is longer than #SCRIPT_TEXT_MAXIMUM.
 */
bool script_text_read_open(ScriptText *script, int file, Error *error);

/**
 * Reads a scene or lesson file and checks that it is text.
 * @param path        Its path; `-`: standard input.
 * @param[out] text   The text, to be released with #script_text_deinit.
 * @param[out] error  `FILE: what is wrong` or `FILE:LINE: what is wrong`.
 * @return Whether it is text.
 */
bool script_text_load(const char *path, ScriptText *text, Error *error);

/**
 * Checks that a file is text, and not compiled Lua, a picture, or UTF-16.
 * @param script      The file.
 * @param[out] line   Line of the first invalid byte, from 1; may be NULL.
 * @param[out] error  What is wrong, without path and line.
 * @return Whether it is text.
 */
bool script_text_check(const ScriptText *script, int *line, Error *error);

/**
 * Finds the Lua text in a file: after a byte order mark, and after a first line for the shell
 * (`#!/usr/bin/dioptre`). The newline of that line is kept for the line numbers.
 * @param script     The file.
 * @param[out] size  Bytes of the text.
 * @return The text, without a final zero; owned by the file.
 */
const char *script_text_body(const ScriptText *script, size_t *size);

/** Releases the text of a file. @param script The file. */
void script_text_deinit(ScriptText *script);

#endif
