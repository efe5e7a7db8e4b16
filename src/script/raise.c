/**
 * @file
 * @brief Errors of a scene.
 */
#include "script/raise.h"

#include "dioptre/error.h"

#include <lauxlib.h>
#include <libintl.h>
#include <stdarg.h>
#include <stdio.h>

int raise_error(lua_State *L, const char *format, ...) {
    char words[ERROR_MESSAGE_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(words, sizeof words, gettext(format), arguments);
    va_end(arguments);
    return luaL_error(L, "%s", words);
}
