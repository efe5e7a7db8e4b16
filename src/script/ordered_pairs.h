/**
 * @file
 * @brief `pairs` and `next` in an order that is the same on every run.
 *
 * Lua's order depends on memory addresses and on a random seed, which differ from run to run: a
 * scene that draws random numbers in a loop over a table would differ too. Here the order is:
 * integers, other numbers, both ascending, strings by their bytes, false, true. Other keys (tables,
 * functions, parts of the scene) have no order; a table may have one of them, which comes last.
 */
#ifndef DIOPTRE_SCRIPT_ORDERED_PAIRS_H
#define DIOPTRE_SCRIPT_ORDERED_PAIRS_H

#include <lua.h>

/**
 * Adds `next` and `pairs` to a table. `pairs` sorts the keys once. `next` sorts them at the first
 * step that is not from an integer to its successor, and remembers them until the last step.
 * @param L  The state, with the table on top, where it stays.
 */
void ordered_pairs_open(lua_State *L);

#endif
