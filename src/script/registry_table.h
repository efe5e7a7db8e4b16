/**
 * @file
 * @brief Tables in Lua's registry, out of a scene's reach.
 */
#ifndef DIOPTRE_SCRIPT_REGISTRY_TABLE_H
#define DIOPTRE_SCRIPT_REGISTRY_TABLE_H

#include <lua.h>
#include <stdbool.h>

/**
 * Pushes a table of the registry. It is created at the first call.
 * @param L        The state.
 * @param key      Any address that is used for nothing else.
 * @param is_weak  Whether the table does not keep its keys alive.
 */
void registry_table_push(lua_State *L, const void *key, bool is_weak);

#endif
