/**
 * @file
 * @brief Texts of tables, functions and other objects, without their addresses.
 *
 * Lua shows addresses in `tostring` and `string.format`. They differ from run to run, so that a
 * picture could, and they tell where the memory of this process lies. Here objects are numbered in
 * the order in which a scene asks for their texts: `table: 1`.
 */
#ifndef DIOPTRE_SCRIPT_OBJECT_NAMES_H
#define DIOPTRE_SCRIPT_OBJECT_NAMES_H

#include <lua.h>

/**
 * Pushes the text of a value, like luaL_tolstring.
 * @param L            The state.
 * @param index        Stack index of the value.
 * @param[out] length  Bytes of the text; may be NULL.
 * @return The text.
 */
const char *object_names_push_text(lua_State *L, int index, size_t *length);

/** `tostring`. See lua_CFunction. @return 1: the text. */
int object_names_tostring(lua_State *L);

/**
 * `string.format`, without `%p`. See lua_CFunction.
 * @param L  The state; the function of Lua's library is the first upvalue.
 * @return 1: the text.
 */
int object_names_format(lua_State *L);

#endif
