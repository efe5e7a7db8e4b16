/**
 * @file
 * @brief Arguments of the functions of lessons that take tables.
 */
#ifndef SCRIPT_LESSON_FIELDS_H
#define SCRIPT_LESSON_FIELDS_H

#include "dioptre/lesson.h"
#include "script/read_parameters.h"

/**
 * Reads the table of `lesson`: `{ scene = "FILE.lua", title = ..., ... }`. Raises an error for
 * invalid fields.
 * @param L       The state; the table is the only argument.
 * @param lesson  The lesson to fill.
 */
void lesson_fields_read(lua_State *L, Lesson *lesson);

/**
 * Reads the argument of `caption`: a string, or `{ en = ..., fr = ..., wait = true }`. Raises an
 * error for anything else.
 * @param L               The state, with the argument.
 * @param[in,out] lesson  The lesson, which owns the text.
 * @param step            The step to fill.
 */
void lesson_fields_read_caption(lua_State *L, Lesson *lesson, LessonStep *step);

/**
 * Reads the table of `ask`: `{ en = ..., fr = ..., choices = {...}, right = 1, because = ... }`.
 * Raises an error for anything else.
 * @param L               The state; the table is the only argument.
 * @param[in,out] lesson  The lesson, which owns the texts.
 * @param question        The question to fill.
 */
void lesson_fields_read_question(lua_State *L, Lesson *lesson, LessonQuestion *question);

#endif
