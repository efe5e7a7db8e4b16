/**
 * @file
 * @brief From a Lua table to a C struct, by a parameter table.
 */
#ifndef DIOPTRE_SCRIPT_READ_PARAMETERS_H
#define DIOPTRE_SCRIPT_READ_PARAMETERS_H

#include "dioptre/parameter.h"

#include <lua.h>

/**
 * Checks the names in the table that a keyword was called with. Raises an error about a field that
 * none of the keywords has.
 * @param L         The state; the table is the only argument.
 * @param keywords  The keyword, and others whose fields may stand there too; ended by NULL.
 * @param extra     A field that the caller reads by itself; NULL: none.
 */
void read_check_arguments(lua_State *L, const Keyword *const *keywords, const char *extra);

/** Checks the names in a table. See #read_check_arguments. @param index Where the table is, from
 *  the bottom of the stack. */
void read_check_table(lua_State *L, int index, const Keyword *const *keywords, const char *extra);

/**
 * Reads the fields of a keyword. Raises an error about a field that is of a wrong type, out of
 * range or does not fit the others.
 * @param L  The state; the table is the first argument.
 * @param[out] given_mask  Bit i is set where row i of the keyword's table was given.
 * @return The keyword's struct, finished: its defaults, and over them what was given. It lies on
 *         top of the stack, and is Lua's, so that an error leaves nothing behind.
 */
void *read_fields(lua_State *L, const Keyword *keyword, uint64_t *given_mask);

/**
 * Reads one value. Raises an error about a wrong type or a wrong range.
 * @param index  Where the value is, from the bottom of the stack.
 * @param[out] field  The C value, of the type that the row says.
 */
void read_value(lua_State *L, int index, const Parameter *row, void *field);

/**
 * Says what a value is, for an error about it: `a string`, `a table`, `a sphere`, in the language
 * that the program speaks.
 * @param L      The state; the answer is left on top.
 * @param index  Where the value is, from the bottom of the stack.
 * @return The answer, valid while it is on the stack.
 */
const char *read_describe(lua_State *L, int index);

/**
 * Raises the error that a value is of a wrong type.
 * @param index  Where the value is.
 * @param expected  The same in English words, looked up here.
 */
void read_type_error(lua_State *L, int index, const Parameter *row, const char *expected);

/** Reads the name of a model file as its place in the scene. See #read_value. */
void read_mesh_name(lua_State *L, int index, const Parameter *row, void *field);

/** Reads the name of a picture file as its place in the scene, plus one. See #read_value. */
void read_texture_name(lua_State *L, int index, const Parameter *row, void *field);

#endif
