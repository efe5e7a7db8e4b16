/**
 * @file
 * @brief Translated errors of a scene.
 */
#ifndef DIOPTRE_SCRIPT_LUA_ERROR_H
#define DIOPTRE_SCRIPT_LUA_ERROR_H

#include <lua.h>

/**
 * Raises an error with the location in the scene in front; see luaL_error. Does not return.
 * @param L       The state.
 * @param format  The message in English, as for printf, translated here; cut at #ERROR_MESSAGE_SIZE
 *                - 1 bytes.
 * @return Never; the type allows `return lua_error_tr(...)`.
 */
int lua_error_tr(lua_State *L, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
