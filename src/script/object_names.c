/**
 * @file
 * @brief Texts of objects, without their addresses.
 */
#include "script/object_names.h"

#include "script/lua_error.h"
#include "script/registry_table.h"
#include "script/script_sandbox.h"

#include <lauxlib.h>
#include <stdbool.h>
#include <string.h>

/** Key in the registry: the numbers of objects. */
static const char object_numbers;

/** @return Whether Lua would show the address of a value. */
static bool has_address(lua_State *L, int index) {
    switch (lua_type(L, index)) {
    case LUA_TTABLE:
    case LUA_TFUNCTION:
    case LUA_TUSERDATA:
    case LUA_TLIGHTUSERDATA:
    case LUA_TTHREAD:
        return true;
    default:
        return false;
    }
}

/** @return Number of an object, from 1, in the order of first questions. */
static lua_Integer number_of(lua_State *L, int index) {
    registry_table_push(L, &object_numbers, true); // It does not keep the objects alive.
    lua_pushvalue(L, index);
    if (lua_rawget(L, -2) != LUA_TNUMBER) {
        lua_pushvalue(L, index);
        lua_pushinteger(L, ++script_sandbox_of(L)->objects_numbered);
        lua_copy(L, -1, -3);
        lua_rawset(L, -4);
    }
    lua_Integer number = lua_tointeger(L, -1);
    lua_pop(L, 2);
    return number;
}

const char *object_names_push_text(lua_State *L, int index, size_t *length) {
    index = lua_absindex(L, index);
    bool has_own_text = luaL_getmetafield(L, index, "__tostring") != LUA_TNIL;
    lua_settop(L, has_own_text ? lua_gettop(L) - 1 : lua_gettop(L));
    if (has_own_text || !has_address(L, index)) {
        return luaL_tolstring(L, index, length);
    }
    lua_Integer number = number_of(L, index);
    int type = luaL_getmetafield(L, index, "__name");
    const char *name = type == LUA_TSTRING ? lua_tostring(L, -1) : luaL_typename(L, index);
    lua_pushfstring(L, "%s: %I", name, (LUAI_UACINT)number);
    if (type != LUA_TNIL) {
        lua_remove(L, -2);
    }
    return lua_tolstring(L, -1, length);
}

int object_names_tostring(lua_State *L) {
    luaL_checkany(L, 1);
    object_names_push_text(L, 1, NULL);
    return 1;
}

int object_names_format(lua_State *L) {
    size_t length;
    const char *format = luaL_checklstring(L, 1, &length), *end = format + length;
    int argument = 1;
    // A format may hold zero bytes; the string ends with one more.
    while ((format = memchr(format, '%', (size_t)(end - format)))) {
        if (format[1] == '%') {
            format += 2;
            continue;
        }
        format += 1 + strspn(format + 1, "-+ #0123456789.");
        argument++;
        if (*format == 'p') {
            return lua_error_tr(L, "string.format takes no %%p here: addresses are others in each "
                                   "run");
        }
        if (*format == 's' && argument <= lua_gettop(L) && has_address(L, argument)) {
            object_names_push_text(L, argument, NULL);
            lua_replace(L, argument);
        }
    }
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}
