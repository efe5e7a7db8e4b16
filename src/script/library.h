/**
 * @file
 * @brief The part of Lua that a scene file may use.
 */
#ifndef SCRIPT_LIBRARY_H
#define SCRIPT_LIBRARY_H

#include <lua.h>

/**
 * Adds the global names of the language: `math`, `string`, `table`, `utf8`, the safe base
 * functions, and `t`, the time of the run. Random numbers have a fixed seed, and `pairs` a fixed
 * order. An unknown name raises an error with the nearest known one.
 * @param L  The state.
 */
void library_open(lua_State *L);

/**
 * Raises an error if a metatable has become one that makes tables weak after it was set: such a
 * table may have lost items at any time. To be called after a run.
 * @param L  The state.
 */
void library_check_metatables(lua_State *L);

/**
 * Makes unknown keys of a table raise errors.
 * @param L          The state, with the table on top.
 * @param name       Its name; empty for the globals.
 * @param separator  Text between the name and the key in errors.
 */
void library_make_strict(lua_State *L, const char *name, const char *separator);

#endif
