/**
 * @file
 * @brief The part of Lua that a scene file may use.
 */
#include "script/library.h"

#include "base/sanitize.h"
#include "base/suggest.h"
#include "script/lua_error.h"
#include "script/object_names.h"
#include "script/ordered_pairs.h"
#include "script/registry_table.h"
#include "script/script_question.h"
#include "script/script_run.h"
#include "script/script_sandbox.h"
#include "script/stable_sort.h"

#include <lauxlib.h>
#include <libintl.h>
#include <lualib.h>
#include <string.h>

/**
 * Base functions without access to files or memory limits. `pairs` and `next` come from
 * script/ordered_pairs.h, `tostring` from script/object_names.h.
 */
static const char *const base_functions[] = {
    "assert", "error",  "getmetatable", "ipairs",       "pcall",    "rawequal", "rawget",
    "rawlen", "rawset", "select",       "setmetatable", "tonumber", "type",     "xpcall"};

/** Libraries without side effects. */
static const luaL_Reg libraries[] = {{LUA_MATHLIBNAME, luaopen_math},
                                     {LUA_STRLIBNAME, luaopen_string},
                                     {LUA_TABLIBNAME, luaopen_table},
                                     {LUA_UTF8LIBNAME, luaopen_utf8}};

/** Prints sanitized text, up to #SCRIPT_PRINT_MAXIMUM bytes per run. */
static void print_sanitized_text(ScriptSandbox *sandbox, const char *text, size_t length) {
    char sanitized[1024];
    /** An escaped byte takes four characters. */
    const size_t piece_maximum = sizeof sanitized / 4 - 1;
    while (length > 0 && sandbox->bytes_printed < SCRIPT_PRINT_MAXIMUM) {
        size_t piece = length < piece_maximum ? length : piece_maximum;
        sanitize_text(sanitized, sizeof sanitized, text, piece);
        script_question_print(sanitized);
        text += piece;
        length -= piece;
        sandbox->bytes_printed += strlen(sanitized);
        if (sandbox->bytes_printed >= SCRIPT_PRINT_MAXIMUM) {
            script_question_print(gettext("\n(the scene printed more, which is left out)\n"));
        }
    }
}

/** `print`, to standard error. See lua_CFunction. @return 0 */
static int library_print(lua_State *L) {
    ScriptSandbox *sandbox = script_sandbox_of(L);
    int count = lua_gettop(L);
    for (int i = 1; i <= count; i++) {
        size_t length;
        const char *text = object_names_push_text(L, i, &length);
        print_sanitized_text(sandbox, text, length);
        print_sanitized_text(sandbox, i < count ? "\t" : "", i < count);
        lua_pop(L, 1);
    }
    print_sanitized_text(sandbox, "\n", 1);
    return 0;
}

/**
 * `math.randomseed`, only with an integer: a seed from the clock would make each image different.
 * See lua_CFunction.
 * @param L  The state; the function of Lua's library is the first upvalue.
 * @return 0
 */
static int library_randomseed(lua_State *L) {
    lua_Integer seed = luaL_checkinteger(L, 1);
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_pushinteger(L, seed);
    lua_call(L, 1, 0);
    return 0;
}

/** Key in the registry: all metatables that a run has set. */
static const char set_metatables;

/** Raises the error of a metatable that makes tables weak. */
static int fail_weak(lua_State *L) {
    return lua_error_tr(L, "a scene may not use __mode: nobody knows when such a table would lose "
                           "its items");
}

/** @return Whether a table has a field, whatever its metatable. @param index Its stack index. */
static bool has_raw_field(lua_State *L, int index, const char *name) {
    lua_pushstring(L, name);
    bool is_found = lua_rawget(L, index) != LUA_TNIL;
    lua_pop(L, 1);
    return is_found;
}

void library_check_metatables(lua_State *L) {
    registry_table_push(L, &set_metatables, false);
    int all = lua_gettop(L);
    lua_pushnil(L);
    while (lua_next(L, all)) {
        lua_pop(L, 1);
        if (has_raw_field(L, lua_gettop(L), "__mode")) {
            fail_weak(L);
        }
    }
    lua_pop(L, 1);
}

/**
 * `setmetatable`, without `__gc` and `__mode`: the time of garbage collection is not reproducible.
 * Lua ignores a `__gc` that is set later; #library_check_metatables finds a later `__mode`. See
 * lua_CFunction.
 * @param L  The state; the function of Lua's library is the first upvalue.
 * @return 1: the table.
 */
static int library_setmetatable(lua_State *L) {
    lua_settop(L, 2);
    if (lua_istable(L, 2)) {
        if (has_raw_field(L, 2, "__gc")) {
            return lua_error_tr(L, "a scene may not use __gc: nobody knows when it would run");
        }
        if (has_raw_field(L, 2, "__mode")) {
            return fail_weak(L);
        }
        registry_table_push(L, &set_metatables, false);
        lua_pushvalue(L, 2);
        lua_pushboolean(L, true);
        lua_rawset(L, -3);
        lua_settop(L, 2);
    }
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/** Most words that one word of the language stands for. */
enum { SYNONYMS_MAXIMUM = 5 };

/** A word of the language, and others that people may write for it. */
typedef struct Synonyms {
    const char *meant;                   /**< The word of the language. */
    const char *words[SYNONYMS_MAXIMUM]; /**< The others, ended by NULL if there are fewer. */
} Synonyms;

/** Words of English and French whose spelling is not near the word of the language. */
static const Synonyms synonyms[] = {
    {"sphere", {"ball", "boule"}},
    {"box", {"cube", "cuboid", "boite", "pave"}},
    {"quad", {"rectangle", "square", "carre", "parallelogram"}},
    {"plane", {"floor", "ground", "sol"}},
    {"cylinder", {"tube", "pipe"}},
    {"disk", {"circle", "cercle", "disque"}},
    {"mesh", {"model", "modele", "maillage"}},
    {"light", {"lamp", "lampe", "lumiere"}},
    {"sun", {"soleil"}},
    {"sky", {"background", "fond", "ciel"}},
    {"distance.torus", {"torus", "tore"}},
};

/** @return Whether the table on which the stack begins has a word, or the table in front of its
 * dot. */
static bool has_word(lua_State *L, const char *word) {
    lua_pushlstring(L, word, strcspn(word, "."));
    bool is_there = lua_rawget(L, 1) != LUA_TNIL;
    lua_pop(L, 1);
    return is_there;
}

/** Suggests the word of the language that a word stands for, if the table has it: a lesson has no
 *  words for shapes. @param L The state, with the table first. */
static void suggest_synonym(lua_State *L, Suggestion *suggestion) {
    for (size_t i = 0; i < sizeof synonyms / sizeof *synonyms; i++) {
        const char *const *words = synonyms[i].words;
        for (int w = 0; w < SYNONYMS_MAXIMUM && words[w]; w++) {
            if (strcmp(suggestion->word, words[w]) == 0 && has_word(L, synonyms[i].meant)) {
                suggestion->best_match = synonyms[i].meant;
            }
        }
    }
}

/**
 * Raises an error for an unknown name in a table of the language. An `__index` metamethod; see
 * lua_CFunction.
 * @param L  The state, with the table and the key; the first upvalue is the name of the table with
 *           a dot, or an empty string.
 * @return 1, nil, for a key that is no string; else it raises an error.
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
    // One letter away is another word of the scene.
    bool is_misspelt = suggestion.best_match && suggestion.distance == 1;
    if (suggestion.prefix[0] == '\0' && !is_misspelt) {
        suggest_synonym(L, &suggestion);
    }
    char hint[SUGGEST_HINT_SIZE];
    return lua_error_tr(L, "unknown word `%s%s`%s", suggestion.prefix, suggestion.word,
                        suggest_hint(&suggestion, hint));
}

/**
 * Reads the global variable `t`, the time, and records that the scene uses it. Any other name
 * raises an error. An `__index` metamethod; see lua_CFunction.
 * @param L  The state, with the table and the key, and the upvalue of #index_unknown.
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
 * Sets the function for unknown names of a table of the language.
 * @param L          The state, with the table on top.
 * @param name       Name of the table.
 * @param separator  Text between the name and the key in errors.
 * @param unknown    The `__index` metamethod, which raises errors.
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

/**
 * Replaces a function of Lua, which becomes the first upvalue of the new one.
 * @param L         The state, with its table on top.
 * @param name      Name of the function.
 * @param function  The new function.
 */
static void override_function(lua_State *L, const char *name, lua_CFunction function) {
    lua_getfield(L, -1, name);
    lua_pushcclosure(L, function, 1);
    lua_setfield(L, -2, name);
}

/**
 * Adds the base functions to the new table of globals.
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
    lua_pushcfunction(L, object_names_tostring);
    lua_setfield(L, -2, "tostring");
    ordered_pairs_open(L);
}

/**
 * Adds a library to the new table of globals.
 * @param L        The state, with the table on top.
 * @param library  Its name, and the function that opens it.
 */
static void open_library(lua_State *L, const luaL_Reg *library) {
    luaL_requiref(L, library->name, library->func, 0);
    library_make_strict(L, library->name, ".");
    lua_setfield(L, -2, library->name);
}

/**
 * Seeds the random numbers, so that they are the same on every run.
 * @param L  The state, with the globals on top.
 */
static void seed_random(lua_State *L) {
    /** Any constant is suitable. */
    const lua_Integer seed = 20210101;
    lua_getfield(L, -1, LUA_MATHLIBNAME);
    lua_getfield(L, -1, "randomseed");
    lua_pushinteger(L, seed);
    lua_call(L, 1, 0);
    override_function(L, "randomseed", library_randomseed);
    lua_pop(L, 1);
}

/** Replaces `table.sort`. @param L The state, with the globals on top. */
static void replace_sort(lua_State *L) {
    lua_getfield(L, -1, LUA_TABLIBNAME);
    lua_pushcfunction(L, stable_sort);
    lua_setfield(L, -2, "sort");
    lua_pop(L, 1);
}

/** Removes the unsafe functions of `string`. @param L The state, with the globals on top. */
static void restrict_string(lua_State *L) {
    lua_getfield(L, -1, LUA_STRLIBNAME);
    lua_pushnil(L);
    lua_setfield(L, -2, "dump");
    override_function(L, "format", object_names_format);
    lua_pop(L, 1);
    // The metatable of strings, protected from changes.
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
    replace_sort(L);
    restrict_string(L);
    make_strict(L, "", "", index_global);
    lua_rawseti(L, LUA_REGISTRYINDEX, LUA_RIDX_GLOBALS);
}
