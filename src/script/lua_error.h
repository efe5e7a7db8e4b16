/**
 * @file
 * @brief Errors of a scene, in the language that the program speaks.
 */
#ifndef DIOPTRE_SCRIPT_LUA_ERROR_H
#define DIOPTRE_SCRIPT_LUA_ERROR_H

#include <lua.h>

/**
 * Raises an error, with the place in the scene before it; see luaL_error. Does not return.
 * @param format  The message in English, as for printf, looked up in the language that the program
 *         speaks; cut at #ERROR_MESSAGE_SIZE - 1 bytes.
 * @return Not at all; an `int` so that a function can end with `return lua_error_tr(...)`.
 */
int lua_error_tr(lua_State *L, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
