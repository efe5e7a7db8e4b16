/**
 * @file
 * @brief `table.sort`, the same on every run.
 *
 * Lua's own takes a pivot from the clock where it makes little progress. Items that are equal in
 * the order then come out in another sequence on each run.
 */
#ifndef DIOPTRE_SCRIPT_STABLE_SORT_H
#define DIOPTRE_SCRIPT_STABLE_SORT_H

#include <lua.h>

/**
 * `table.sort(list, comp)` by merging: equal items keep their sequence. The list is written at the
 * end, so it is whole if the order function fails. See lua_CFunction.
 * @param L  The state.
 * @return 0
 */
int stable_sort(lua_State *L);

#endif
