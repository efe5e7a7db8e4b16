/**
 * @file
 * @brief Translated errors of a scene.
 */
#include "script/lua_error.h"

#include "base/error.h"

#include <lauxlib.h>
#include <libintl.h>
#include <stdarg.h>
#include <stdio.h>

int lua_error_tr(lua_State *L, const char *format, ...) {
    char message[ERROR_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(message, sizeof message, gettext(format), arguments);
    va_end(arguments);
    return luaL_error(L, "%s", message);
}
