/**
 * @file
 * @brief `table.sort`, the same on every run.
 */
#include "script/stable_sort.h"

#include <lauxlib.h>
#include <limits.h>
#include <stdbool.h>

/** Stack indices of #stable_sort. */
enum {
    STACK_LIST = 1,   /**< The list. */
    STACK_PRECEDES,   /**< The order function; nil: `<`. */
    STACK_SORTED,     /**< Items, sorted in runs. */
    STACK_MERGED,     /**< Space for runs of twice the length. */
    STACK_FIRST_ITEM, /**< Next item of the first run. */
    STACK_SECOND_ITEM /**< Next item of the second run. */
};

/** Two neighbouring runs to merge. */
typedef struct RunPair {
    lua_Integer first;  /**< Next item of the first run. */
    lua_Integer second; /**< Next item of the second run. */
    lua_Integer middle; /**< Start of the second run. */
    lua_Integer end;    /**< End of the second run, exclusive. */
} RunPair;

/** @return Whether the item of the second run precedes that of the first. */
static bool second_precedes(lua_State *L) {
    if (lua_isnil(L, STACK_PRECEDES)) {
        return lua_compare(L, STACK_SECOND_ITEM, STACK_FIRST_ITEM, LUA_OPLT);
    }
    lua_pushvalue(L, STACK_PRECEDES);
    lua_pushvalue(L, STACK_SECOND_ITEM);
    lua_pushvalue(L, STACK_FIRST_ITEM);
    lua_call(L, 2, 1);
    bool is_true = lua_toboolean(L, -1);
    lua_pop(L, 1);
    return is_true;
}

/** Replaces an item on the stack by one of the sorted runs. */
static void load_item(lua_State *L, lua_Integer place, int index) {
    lua_rawgeti(L, STACK_SORTED, place);
    lua_replace(L, index);
}

/** Merges two runs. */
static void merge(lua_State *L, RunPair runs) {
    load_item(L, runs.first, STACK_FIRST_ITEM);
    load_item(L, runs.second, STACK_SECOND_ITEM);
    for (lua_Integer to = runs.first; to < runs.end; to++) {
        bool takes_second =
            runs.first == runs.middle || (runs.second < runs.end && second_precedes(L));
        lua_pushvalue(L, takes_second ? STACK_SECOND_ITEM : STACK_FIRST_ITEM);
        lua_rawseti(L, STACK_MERGED, to);
        if (takes_second && ++runs.second < runs.end) {
            load_item(L, runs.second, STACK_SECOND_ITEM);
        } else if (!takes_second && ++runs.first < runs.middle) {
            load_item(L, runs.first, STACK_FIRST_ITEM);
        }
    }
}

/** @return The smaller of two integers. */
static lua_Integer minimum(lua_Integer a, lua_Integer b) {
    return a < b ? a : b;
}

/** Merges runs until one is left. @param count Number of items. */
static void merge_all(lua_State *L, lua_Integer count) {
    for (lua_Integer length = 1; length < count; length *= 2) {
        for (lua_Integer start = 1; start <= count; start += 2 * length) {
            lua_Integer middle = minimum(start + length, count + 1);
            merge(L, (RunPair){start, middle, middle, minimum(middle + length, count + 1)});
        }
        lua_pushvalue(L, STACK_SORTED);
        lua_copy(L, STACK_MERGED, STACK_SORTED);
        lua_replace(L, STACK_MERGED);
    }
}

int stable_sort(lua_State *L) {
    luaL_checktype(L, STACK_LIST, LUA_TTABLE);
    const lua_Integer count = luaL_len(L, STACK_LIST);
    if (count < 2) {
        return 0;
    }
    luaL_argcheck(L, count < INT_MAX, STACK_LIST, "array too big");
    if (!lua_isnoneornil(L, STACK_PRECEDES)) {
        luaL_checktype(L, STACK_PRECEDES, LUA_TFUNCTION);
    }
    lua_settop(L, STACK_PRECEDES);
    lua_createtable(L, (int)count, 0);
    lua_createtable(L, (int)count, 0);
    lua_settop(L, STACK_SECOND_ITEM);
    for (lua_Integer i = 1; i <= count; i++) {
        lua_geti(L, STACK_LIST, i);
        lua_rawseti(L, STACK_SORTED, i);
    }
    merge_all(L, count);
    for (lua_Integer i = 1; i <= count; i++) {
        lua_rawgeti(L, STACK_SORTED, i);
        lua_seti(L, STACK_LIST, i);
    }
    return 0;
}
