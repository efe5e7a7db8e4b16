/**
 * @file
 * @brief The part of Lua that a scene file may use.
 */
#ifndef SCRIPT_LIBRARY_H
#define SCRIPT_LIBRARY_H

#include <lua.h>

/** Most that a scene may print, bytes; then a last line says so. */
enum { LIBRARY_PRINT_MAXIMUM = 65536 };

/** Gives a state its global words: `math`, `string`, `table`, `utf8`, and the base functions that
 *  read nothing, and `t`, the time of the run. Random numbers start from a fixed seed, `pairs` has
 *  a fixed order, and a word that is not there raises an error with the nearest one that is. */
void library_open(lua_State *L);

/**
 * Makes a table of the language raise errors about words that it does not have.
 * @param L     The state, with the table on top.
 * @param name  Its name; nothing for the global words.
 * @param separator   What stands between the name and a word.
 */
void library_make_strict(lua_State *L, const char *name, const char *separator);

#endif
