/**
 * @file
 * @brief Telling lesson files from scene files, by their text.
 */
#ifndef DIOPTRE_BASE_LESSON_FILE_H
#define DIOPTRE_BASE_LESSON_FILE_H

#include <limits.h>
#include <stdbool.h>

/** @return Whether a text of Lua is a lesson: it calls `lesson`, outside of comments and strings.
 *  @param text Its beginning, ended by a zero. */
bool lesson_file_is_text(const char *text);

/** @return Whether a file is a lesson. It is read, but not run. */
bool lesson_file_is(const char *path);

/**
 * Finds the lesson after another: the next one in its folder by file name.
 * @param path       The lesson's file.
 * @param[out] next  The next one's file.
 * @return Whether there is one.
 */
bool lesson_file_next(const char *path, char next[PATH_MAX]);

#endif
