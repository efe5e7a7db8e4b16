/**
 * @file
 * @brief `pairs` and `next` in an order that is the same on every run.
 *
 * Lua's own order depends on where the memory lies, which differs from run to run: a scene that
 * goes through a table and draws random numbers would never look the same twice. Here the order is:
 * whole numbers upwards, other numbers upwards, text by its bytes, false, true; and then what
 * has no order of its own (tables, functions, things of the scene), as Lua has it.
 */
#ifndef DIOPTRE_SCRIPT_ORDERED_PAIRS_H
#define DIOPTRE_SCRIPT_ORDERED_PAIRS_H

#include <lua.h>

/**
 * Puts `next` and `pairs` into a table. From one whole number to the following is one step;
 * any other step looks at all keys of the table.
 * @param L  The state, with the table on top of its stack, where it stays.
 */
void ordered_pairs_open(lua_State *L);

#endif
