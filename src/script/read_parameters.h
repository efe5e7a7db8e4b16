/**
 * @file
 * @brief Conversion of Lua tables to C structs by parameter tables.
 */
#ifndef DIOPTRE_SCRIPT_READ_PARAMETERS_H
#define DIOPTRE_SCRIPT_READ_PARAMETERS_H

#include "dioptre/parameter.h"

#include <lua.h>

/**
 * Checks the names of fields in the table of a keyword. Raises an error for a field that no keyword
 * has.
 * @param L         The state; the table is the only argument.
 * @param keywords  The keyword, and others whose fields are valid there; NULL ends the list.
 * @param nested    A keyword whose name is a field that the caller reads itself; NULL: none.
 */
void read_check_arguments(lua_State *L, const Keyword *const *keywords, const Keyword *nested);

/**
 * Checks the names of fields in a table. See #read_check_arguments.
 * @param L         The state.
 * @param index     Stack index of the table, from the bottom.
 * @param keywords  The keywords; NULL ends the list.
 * @param nested    A keyword whose name is a further valid field; NULL: none.
 */
void read_check_table(lua_State *L, int index, const Keyword *const *keywords,
                      const Keyword *nested);

/**
 * Reads the fields of a keyword. Raises an error for a field of the wrong type, out of range or
 * inconsistent with others.
 * @param L                The state; the table is the first argument.
 * @param keyword          The keyword.
 * @param[out] given_mask  Bit i: the table has row i.
 * @return The keyword's struct, finished: its defaults, replaced by the given values. It is a
 *         userdata on top of the stack, which Lua frees even after an error.
 */
void *read_fields(lua_State *L, const Keyword *keyword, uint64_t *given_mask);

/**
 * Reads one value. Raises an error for a wrong type or range.
 * @param L           The state.
 * @param index       Stack index of the value, from the bottom.
 * @param row         Row of the parameter table.
 * @param[out] field  The C value, of the type that the row requires.
 */
void read_value(lua_State *L, int index, const Parameter *row, void *field);

/**
 * Describes a value for an error: `a string`, `a table`, `a sphere`, translated.
 * @param L      The state; the description is pushed.
 * @param index  Stack index of the value, from the bottom.
 * @return The description, valid while it is on the stack.
 */
const char *read_describe(lua_State *L, int index);

/**
 * Raises the error that a value has the wrong type.
 * @param L         The state.
 * @param index     Stack index of the value.
 * @param row       Row of the parameter table.
 * @param expected  The expected type in English, translated here.
 */
void read_type_error(lua_State *L, int index, const Parameter *row, const char *expected);

/** Reads the name of a mesh file as its index in the scene. See #read_value. */
void read_mesh_name(lua_State *L, int index, const Parameter *row, void *field);

/** Reads the name of a picture file as its index in the scene, plus one. See #read_value. */
void read_texture_name(lua_State *L, int index, const Parameter *row, void *field);

#endif
