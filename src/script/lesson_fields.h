/**
 * @file
 * @brief The tables that the words of lessons are called with.
 */
#ifndef SCRIPT_LESSON_FIELDS_H
#define SCRIPT_LESSON_FIELDS_H

#include "dioptre/lesson.h"
#include "script/read_parameters.h"

/** Reads what `lesson` was called with: `{ scene = "FILE.lua", title = ..., ... }`. Raises an error
 *  about anything else. @param L The state; the table is the only argument. */
void lesson_fields_read(lua_State *L, Lesson *lesson);

/**
 * Reads what `caption` was called with: words, or `{ en = ..., fr = ..., wait = true }`. Raises an
 * error about anything else.
 * @param L  The state; it is the only argument.
 * @param[in,out] lesson  The lesson, which keeps the words.
 */
void lesson_fields_read_caption(lua_State *L, Lesson *lesson, LessonStep *step);

#endif
