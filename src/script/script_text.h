/**
 * @file
 * @brief The text of a scene file.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_TEXT_H
#define DIOPTRE_SCRIPT_SCRIPT_TEXT_H

#include "base/error.h"

#include <stddef.h>

/** Longest scene file, bytes: more than anybody writes, less than would be felt. */
#define SCRIPT_TEXT_MAXIMUM ((size_t)16 << 20)

/** A file that was read whole. */
typedef struct ScriptText {
    char *text;  /**< Its bytes; owned. */
    size_t size; /**< How many. */
} ScriptText;

/**
 * Reads a file. Only a regular file is opened, so that no FIFO or device can keep the program
 * waiting.
 * @param[out] script  The file; give it back with #script_text_deinit.
 * @param path         Where it is; `-` reads standard input to its end.
 * @param[out] error   What is wrong, without the path.
 * @return false if it cannot be read, or is longer than #SCRIPT_TEXT_MAXIMUM.
 */
bool script_text_read(ScriptText *script, const char *path, Error *error);

/**
 * Reads a scene or lesson file that is to be run, and checks that it is text.
 * @param[out] text  The text; give it back with #script_text_deinit.
 * @param[out] error  `FILE: what is wrong` or `FILE:LINE: what is wrong`.
 * @return Whether it is text.
 */
bool script_text_load(const char *path, ScriptText *text, Error *error);

/**
 * Says whether a file holds text, as against compiled Lua, a picture, or text in UTF-16.
 * @param[out] line  Where it does not, from 1; may be NULL.
 * @param[out] error  What is wrong, without path and line.
 * @return Whether it does.
 */
bool script_text_check(const ScriptText *script, int *line, Error *error);

/** Finds the Lua text in a file: after the mark that Windows puts before UTF-8, and after a first
 *  line for the shell (`#!/usr/bin/dioptre`), whose end stays so that lines keep their numbers.
 *  @return The text, not ended by a zero; owned by the source. */
const char *script_text_body(const ScriptText *script, size_t *size);

/** Gives a file's text back. */
void script_text_deinit(ScriptText *script);

#endif
