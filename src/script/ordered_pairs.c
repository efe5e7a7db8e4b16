/**
 * @file
 * @brief `pairs` and `next` in an order that is the same on every run.
 */
#include "script/ordered_pairs.h"

#include <lauxlib.h>
#include <stdbool.h>

/** Kinds of keys, in their order. */
typedef enum {
    RANK_INTEGER,  /**< Integers. */
    RANK_FLOAT,    /**< Other numbers. */
    RANK_STRING,   /**< Strings. */
    RANK_BOOLEAN,  /**< false, true. */
    RANK_UNORDERED /**< Keys without an order. */
} KeyRank;

/** Stack indices in #ordered_next. */
enum { STACK_TABLE = 1, STACK_KEY = 2, STACK_BEST = 3 };

/** @return The kind of a key. @param L The state. @param index Its index on the stack. */
static KeyRank rank_of(lua_State *L, int index) {
    switch (lua_type(L, index)) {
    case LUA_TNUMBER:
        return lua_isinteger(L, index) ? RANK_INTEGER : RANK_FLOAT;
    case LUA_TSTRING:
        return RANK_STRING;
    case LUA_TBOOLEAN:
        return RANK_BOOLEAN;
    default:
        return RANK_UNORDERED;
    }
}

/**
 * @return Whether a key precedes another.
 * @param L  The state.
 * @param a  Stack index of the first; it has an order.
 * @param b  Stack index of the second.
 */
static bool key_precedes(lua_State *L, int a, int b) {
    KeyRank rank = rank_of(L, a), other = rank_of(L, b);
    if (rank != other) {
        return rank < other;
    }
    if (rank == RANK_BOOLEAN) {
        return lua_toboolean(L, a) < lua_toboolean(L, b);
    }
    return lua_compare(L, a, b, LUA_OPLT);
}

/**
 * Finds the integer key after an integer key, without a search.
 * @param L  The state; the key found is pushed.
 * @return Whether the table has it.
 */
static bool find_next_integer(lua_State *L) {
    if (!lua_isinteger(L, STACK_KEY)) {
        return false;
    }
    lua_Integer next = (lua_Integer)((lua_Unsigned)lua_tointeger(L, STACK_KEY) + 1);
    bool is_found = next != LUA_MININTEGER && lua_rawgeti(L, STACK_TABLE, next) != LUA_TNIL;
    lua_settop(L, STACK_KEY);
    if (is_found) {
        lua_pushinteger(L, next);
    }
    return is_found;
}

/**
 * Finds the first key after a given one among those with an order, by a search of all keys.
 * @param L  The state; the key found is pushed.
 * @return Whether there is one.
 */
static bool find_next_ordered(lua_State *L) {
    bool is_start = lua_isnil(L, STACK_KEY);
    lua_settop(L, STACK_BEST);
    lua_pushnil(L);
    while (lua_next(L, STACK_TABLE)) {
        lua_pop(L, 1);
        const int key = STACK_BEST + 1;
        bool is_after =
            rank_of(L, key) != RANK_UNORDERED && (is_start || key_precedes(L, STACK_KEY, key));
        if (is_after && (lua_isnil(L, STACK_BEST) || key_precedes(L, key, STACK_BEST))) {
            lua_copy(L, key, STACK_BEST);
        }
    }
    return !lua_isnil(L, STACK_BEST);
}

/**
 * Finds the next key without an order.
 * @param L  The state; the key found is pushed.
 * @return Whether there is one.
 */
static bool find_next_unordered(lua_State *L) {
    lua_settop(L, STACK_KEY);
    if (rank_of(L, STACK_KEY) == RANK_UNORDERED) {
        lua_pushvalue(L, STACK_KEY);
    } else {
        lua_pushnil(L);
    }
    while (lua_next(L, STACK_TABLE)) {
        lua_pop(L, 1);
        if (rank_of(L, -1) == RANK_UNORDERED) {
            return true;
        }
    }
    return false;
}

/**
 * `next`: from a table and a key to the next key and its value. See lua_CFunction.
 * @param L  The state.
 * @return 2, or 1 at the end: nil.
 */
static int ordered_next(lua_State *L) {
    luaL_checktype(L, STACK_TABLE, LUA_TTABLE);
    lua_settop(L, STACK_KEY);
    bool has_order = lua_isnil(L, STACK_KEY) || rank_of(L, STACK_KEY) != RANK_UNORDERED;
    bool is_found = has_order && (find_next_integer(L) || find_next_ordered(L));
    if (!is_found && !find_next_unordered(L)) {
        lua_pushnil(L);
        return 1;
    }
    lua_pushvalue(L, -1);
    lua_rawget(L, STACK_TABLE);
    return 2;
}

/** `pairs`. See lua_CFunction. @return 3: #ordered_next, the table, nil. */
static int ordered_pairs(lua_State *L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    lua_pushcfunction(L, ordered_next);
    lua_pushvalue(L, 1);
    lua_pushnil(L);
    return 3;
}

void ordered_pairs_open(lua_State *L) {
    static const luaL_Reg functions[] = {
        {"next", ordered_next}, {"pairs", ordered_pairs}, {NULL, NULL}};
    luaL_setfuncs(L, functions, 0);
}
