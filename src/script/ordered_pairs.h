/**
 * @file
 * @brief `pairs` and `next` in an order that is the same on every run.
 *
 * Lua's order depends on memory addresses, which differ from run to run: a scene that draws random
 * numbers in a loop over a table would differ too. Here the order is: integers, other numbers, both
 * ascending, strings by their bytes, false, true. Keys without an order (tables, functions, parts
 * of the scene) follow in the order of Lua.
 */
#ifndef DIOPTRE_SCRIPT_ORDERED_PAIRS_H
#define DIOPTRE_SCRIPT_ORDERED_PAIRS_H

#include <lua.h>

/**
 * Adds `next` and `pairs` to a table. A step between successive integers takes constant time; any
 * other step searches all keys of the table.
 * @param L  The state, with the table on top, where it stays.
 */
void ordered_pairs_open(lua_State *L);

#endif
