/**
 * @file
 * @brief The part of Lua that a scene file may use.
 */
#include "script/library.h"

#include "base/suggest.h"
#include "script/lua_error.h"
#include "script/ordered_pairs.h"
#include "script/sanitize.h"
#include "script/script_run.h"
#include "script/script_sandbox.h"

#include <lauxlib.h>
#include <libintl.h>
#include <lualib.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/** Base functions that read nothing and undo nothing here. `pairs` and `next` are our own. */
static const char *const base_functions[] = {
    "assert", "error",  "getmetatable", "ipairs",   "pcall",    "rawequal", "rawget", "rawlen",
    "rawset", "select", "setmetatable", "tonumber", "tostring", "type",     "xpcall"};

/** Libraries that only compute. */
static const luaL_Reg libraries[] = {{LUA_MATHLIBNAME, luaopen_math},
                                     {LUA_STRLIBNAME, luaopen_string},
                                     {LUA_TABLIBNAME, luaopen_table},
                                     {LUA_UTF8LIBNAME, luaopen_utf8}};

/** Writes to standard error, as far as it goes. */
static void write_error(const char *text, size_t length) {
    while (length > 0) {
        ssize_t count = write(STDERR_FILENO, text, length);
        if (count <= 0) {
            return;
        }
        text += count;
        length -= (size_t)count;
    }
}

/** Prints clean text, until the sandbox has printed enough. */
static void print_sanitized_text(ScriptSandbox *sandbox, const char *text, size_t length) {
    char sanitized[1024];
    /** An escaped byte takes four. */
    const size_t piece_maximum = sizeof sanitized / 4 - 1;
    while (length > 0 && sandbox->bytes_printed < LIBRARY_PRINT_MAXIMUM) {
        size_t piece = length < piece_maximum ? length : piece_maximum;
        sanitize_text(sanitized, sizeof sanitized, text, piece);
        write_error(sanitized, strlen(sanitized));
        text += piece;
        length -= piece;
        sandbox->bytes_printed += strlen(sanitized);
        if (sandbox->bytes_printed >= LIBRARY_PRINT_MAXIMUM) {
            const char *notice = gettext("\n(the scene printed more, which is left out)\n");
            write_error(notice, strlen(notice));
        }
    }
}

/** The scene language's `print`: to standard error. See lua_CFunction. @return 0: no results. */
static int library_print(lua_State *L) {
    ScriptSandbox *sandbox = script_sandbox_of(L);
    int count = lua_gettop(L);
    for (int i = 1; i <= count; i++) {
        size_t length;
        const char *text = luaL_tolstring(L, i, &length);
        print_sanitized_text(sandbox, text, length);
        print_sanitized_text(sandbox, i < count ? "\t" : "", i < count);
        lua_pop(L, 1);
    }
    print_sanitized_text(sandbox, "\n", 1);
    return 0;
}

/**
 * The scene language's `math.randomseed`: only from a whole number, since a seed from the clock
 * would make every picture another. See lua_CFunction.
 * @param L  The state; the function of Lua's library is the first upvalue.
 * @return 0: no results.
 */
static int library_randomseed(lua_State *L) {
    lua_Integer seed = luaL_checkinteger(L, 1);
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_pushinteger(L, seed);
    lua_call(L, 1, 0);
    return 0;
}

/**
 * The scene language's `setmetatable`: without `__gc`, which would run at a moment that nobody can
 * foresee. See lua_CFunction.
 * @param L  The state; the function of Lua's library is the first upvalue.
 * @return 1: the table.
 */
static int library_setmetatable(lua_State *L) {
    lua_settop(L, 2);
    if (lua_istable(L, 2)) {
        lua_pushliteral(L, "__gc");
        if (lua_rawget(L, 2) != LUA_TNIL) {
            return lua_error_tr(L, "a scene may not use __gc: nobody knows when it would run");
        }
        lua_settop(L, 2);
    }
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/**
 * Raises an error about a word that is not in a table of the language. An `__index` metamethod;
 * see lua_CFunction.
 * @param L  The state, with the table and the word; the name of the table and a dot, or nothing,
 *           is the first upvalue.
 * @return Not at all, or 1 for a key that is no word: nil.
 */
static int index_unknown(lua_State *L) {
    if (lua_type(L, 2) != LUA_TSTRING) {
        lua_pushnil(L);
        return 1;
    }
    Suggestion suggestion = {.prefix = lua_tostring(L, lua_upvalueindex(1)),
                             .word = lua_tostring(L, 2)};
    lua_pushnil(L);
    while (lua_next(L, 1)) {
        lua_pop(L, 1);
        if (lua_type(L, -1) == LUA_TSTRING) {
            suggest_try(&suggestion, lua_tostring(L, -1));
        }
    }
    char hint[SUGGEST_HINT_SIZE];
    return lua_error_tr(L, "unknown word `%s%s`%s", suggestion.prefix, suggestion.word,
                        suggest_hint(&suggestion, hint));
}

/**
 * Finds a global word that is not in their table: a scene's `t`, the time. It is not kept there so
 * that it is seen whether a scene asks for it. Any other raises an error. An `__index` metamethod;
 * see lua_CFunction.
 * @param L  The state, with the table and the word; #index_unknown's upvalue.
 * @return 1: the time.
 */
static int index_global(lua_State *L) {
    const ScriptRun *run = script_sandbox_of(L)->context;
    bool is_time = lua_type(L, 2) == LUA_TSTRING && strcmp(lua_tostring(L, 2), "t") == 0;
    if (!is_time || !run->scene) {
        return index_unknown(L);
    }
    run->scene->is_time_dependent = true;
    lua_pushnumber(L, run->request->time);
    return 1;
}

/**
 * Makes a table of the language ask a function about words that it does not have.
 * @param L  The state, with the table on top.
 * @param separator  What stands between it and the word.
 * @param unknown  The function, which raises errors.
 */
static void make_strict(lua_State *L, const char *name, const char *separator,
                        lua_CFunction unknown) {
    lua_createtable(L, 0, 2);
    lua_pushfstring(L, "%s%s", name, separator);
    lua_pushcclosure(L, unknown, 1);
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, false);
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);
}

void library_make_strict(lua_State *L, const char *name, const char *separator) {
    make_strict(L, name, separator, index_unknown);
}

/** Puts one of our functions in the place of one of Lua's, which becomes its first upvalue. @param
 *  L The state, with the table that holds it on top. */
static void override_function(lua_State *L, const char *name, lua_CFunction function) {
    lua_getfield(L, -1, name);
    lua_pushcclosure(L, function, 1);
    lua_setfield(L, -2, name);
}

/**
 * Puts the base functions into the new table of global words.
 * @param L  The state, with the table on top.
 */
static void open_base(lua_State *L) {
    luaL_requiref(L, LUA_GNAME, luaopen_base, 0);
    for (size_t i = 0; i < sizeof base_functions / sizeof *base_functions; i++) {
        lua_getfield(L, -1, base_functions[i]);
        lua_setfield(L, -3, base_functions[i]);
    }
    lua_pop(L, 1);
    override_function(L, "setmetatable", library_setmetatable);
    lua_pushcfunction(L, library_print);
    lua_setfield(L, -2, "print");
    ordered_pairs_open(L);
}

/**
 * Puts a library into the new table of global words.
 * @param L        The state, with the table on top.
 * @param library  Its name, and what opens it.
 */
static void open_library(lua_State *L, const luaL_Reg *library) {
    luaL_requiref(L, library->name, library->func, 0);
    library_make_strict(L, library->name, ".");
    lua_setfield(L, -2, library->name);
}

/** Makes random numbers the same on every run. @param L The state, with the words on top. */
static void seed_random(lua_State *L) {
    /** Any number does. */
    const lua_Integer seed = 20210101;
    lua_getfield(L, -1, LUA_MATHLIBNAME);
    lua_getfield(L, -1, "randomseed");
    lua_pushinteger(L, seed);
    lua_call(L, 1, 0);
    override_function(L, "randomseed", library_randomseed);
    lua_pop(L, 1);
}

/** Takes what could be a way out of `string`. @param L The state, with the words on top. */
static void restrict_string(lua_State *L) {
    lua_getfield(L, -1, LUA_STRLIBNAME);
    lua_pushnil(L);
    lua_setfield(L, -2, "dump");
    lua_pop(L, 1);
    // What all texts share: it stays as it is.
    lua_pushliteral(L, "");
    lua_getmetatable(L, -1);
    lua_pushboolean(L, false);
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 2);
}

void library_open(lua_State *L) {
    lua_newtable(L);
    open_base(L);
    for (size_t i = 0; i < sizeof libraries / sizeof *libraries; i++) {
        open_library(L, &libraries[i]);
    }
    seed_random(L);
    restrict_string(L);
    make_strict(L, "", "", index_global);
    lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
}
