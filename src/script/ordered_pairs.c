/**
 * @file
 * @brief `pairs` and `next` in an order that is the same on every run.
 */
#include "script/ordered_pairs.h"

#include "script/lua_error.h"
#include "script/registry_table.h"

#include <lauxlib.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/** Kinds of keys, in their order. */
typedef enum {
    RANK_INTEGER,  /**< Integers. */
    RANK_FLOAT,    /**< Other numbers. */
    RANK_STRING,   /**< Strings. */
    RANK_BOOLEAN,  /**< false, true. */
    RANK_UNORDERED /**< Keys without an order. */
} KeyRank;

/** A key to sort. */
typedef struct SortKey {
    KeyRank rank; /**< Its kind. */
    union {
        lua_Integer integer; /**< The integer or boolean. */
        lua_Number number;   /**< The number. */
        const char *string;  /**< The string, owned by Lua; a key of the table. */
    } value;                 /**< Its value. */
    size_t length;           /**< Bytes of the string. */
} SortKey;

/** Stack indices of the arguments. */
enum { STACK_TABLE = 1, STACK_KEY = 2 };

/** Upvalues of #next_of_pairs. */
enum {
    UPVALUE_KEYS = 1, /**< The sorted keys; nil: they are the integers from 1. */
    UPVALUE_COUNT,    /**< Number of keys. */
    UPVALUE_POSITION, /**< Number of keys passed. */
    UPVALUES = UPVALUE_POSITION
};

/** Key in the registry: the tables that `next` walks through, with their sorted keys. */
static const char walked_tables;

// --- order ---------------------------------------------------------------------------------------

/** @return A key, to be sorted. @param L The state. @param index Its index on the stack. */
static SortKey sort_key_of(lua_State *L, int index) {
    SortKey key = {.rank = RANK_UNORDERED};
    switch (lua_type(L, index)) {
    case LUA_TNUMBER:
        if (lua_isinteger(L, index)) {
            key.rank = RANK_INTEGER;
            key.value.integer = lua_tointeger(L, index);
        } else {
            key.rank = RANK_FLOAT;
            key.value.number = lua_tonumber(L, index);
        }
        break;
    case LUA_TSTRING:
        key.rank = RANK_STRING;
        key.value.string = lua_tolstring(L, index, &key.length);
        break;
    case LUA_TBOOLEAN:
        key.rank = RANK_BOOLEAN;
        key.value.integer = lua_toboolean(L, index);
        break;
    default:
        break;
    }
    return key;
}

/** @return The order of two strings, by their bytes: negative, 0 or positive. */
static int compare_strings(const SortKey *a, const SortKey *b) {
    size_t shorter = a->length < b->length ? a->length : b->length;
    int order = memcmp(a->value.string, b->value.string, shorter);
    return order ? order : (a->length > b->length) - (a->length < b->length);
}

/** @return The order of two keys, for qsort. Keys of a table differ, but for two without order. */
static int compare_keys(const void *first, const void *second) {
    const SortKey *a = first, *b = second;
    if (a->rank != b->rank) {
        return a->rank < b->rank ? -1 : 1;
    }
    switch (a->rank) {
    case RANK_INTEGER:
    case RANK_BOOLEAN:
        return (a->value.integer > b->value.integer) - (a->value.integer < b->value.integer);
    case RANK_FLOAT:
        return (a->value.number > b->value.number) - (a->value.number < b->value.number);
    case RANK_STRING:
        return compare_strings(a, b);
    default:
        return 0;
    }
}

/** Pushes a key that has an order. */
static void push_sort_key(lua_State *L, const SortKey *key) {
    switch (key->rank) {
    case RANK_INTEGER:
        lua_pushinteger(L, key->value.integer);
        break;
    case RANK_FLOAT:
        lua_pushnumber(L, key->value.number);
        break;
    case RANK_STRING:
        lua_pushlstring(L, key->value.string, key->length);
        break;
    default:
        lua_pushboolean(L, (int)key->value.integer);
        break;
    }
}

/** Raises the error of a table with two keys that have no order. */
static void fail_unordered(lua_State *L) {
    lua_error_tr(L, "pairs has no order for keys that are tables, functions or parts of the scene; "
                    "put them into a list");
}

// --- sorted keys ---------------------------------------------------------------------------------

/** The keys of a table, counted. */
typedef struct KeyCount {
    lua_Integer all;       /**< Number of keys. */
    lua_Integer unordered; /**< Number of keys without an order. */
    bool is_list;          /**< Whether they are the integers from 1 to #all. */
} KeyCount;

/** @return The number of keys of a table. @param L The state. @param table Its stack index. */
static KeyCount count_keys(lua_State *L, int table) {
    KeyCount count = {0};
    lua_Integer length = (lua_Integer)lua_rawlen(L, table), listed = 0;
    lua_pushnil(L);
    while (lua_next(L, table)) {
        lua_pop(L, 1);
        const SortKey key = sort_key_of(L, -1);
        count.all++;
        count.unordered += key.rank == RANK_UNORDERED;
        listed += key.rank == RANK_INTEGER && key.value.integer >= 1 && key.value.integer <= length;
    }
    count.is_list = listed == count.all && listed == length;
    return count;
}

/**
 * Fills an array with the keys of a table that have an order.
 * @param L      The state; a key without an order is pushed.
 * @param table  Stack index of the table.
 * @param keys   The array.
 * @return Number of keys in the array.
 */
static size_t collect_keys(lua_State *L, int table, SortKey *keys) {
    size_t count = 0;
    lua_pushnil(L); // The key without an order, or nil.
    lua_pushnil(L);
    while (lua_next(L, table)) {
        lua_pop(L, 1);
        const SortKey key = sort_key_of(L, -1);
        if (key.rank == RANK_UNORDERED) {
            lua_copy(L, -1, -2);
        } else {
            keys[count++] = key;
        }
    }
    return count;
}

/**
 * Pushes a list of the keys of a table, in their order; raises an error if they have none.
 * @param L      The state.
 * @param table  Stack index of the table.
 * @param count  Its keys.
 */
static void push_sorted_keys(lua_State *L, int table, const KeyCount *count) {
    if (count->unordered > 1) {
        fail_unordered(L);
    }
    lua_createtable(L, (int)count->all, 0);
    int list = lua_gettop(L);
    // A userdata, so that the memory limit counts it and an error frees it.
    SortKey *keys = lua_newuserdatauv(L, ((size_t)count->all + 1) * sizeof *keys, 0);
    size_t sorted = collect_keys(L, table, keys);
    qsort(keys, sorted, sizeof *keys, compare_keys);
    if (!lua_isnil(L, -1)) {
        lua_rawseti(L, list, (lua_Integer)sorted + 1);
    }
    for (size_t i = 0; i < sorted; i++) {
        push_sort_key(L, &keys[i]);
        lua_rawseti(L, list, (lua_Integer)i + 1);
    }
    lua_settop(L, list);
}

// --- pairs ---------------------------------------------------------------------------------------

/**
 * The next key of `pairs` and its value. Keys whose values were removed meanwhile are left out. See
 * lua_CFunction.
 * @param L  The state, with the table.
 * @return 2, or 1 at the end: nil.
 */
static int next_of_pairs(lua_State *L) {
    lua_Integer position = lua_tointeger(L, lua_upvalueindex(UPVALUE_POSITION));
    const lua_Integer count = lua_tointeger(L, lua_upvalueindex(UPVALUE_COUNT));
    const bool is_list = lua_isnil(L, lua_upvalueindex(UPVALUE_KEYS));
    bool is_found = false;
    luaL_checktype(L, STACK_TABLE, LUA_TTABLE);
    while (position < count && !is_found) {
        lua_settop(L, STACK_TABLE);
        position++;
        if (is_list) {
            lua_pushinteger(L, position);
        } else {
            lua_rawgeti(L, lua_upvalueindex(UPVALUE_KEYS), position);
        }
        lua_pushvalue(L, -1);
        is_found = lua_rawget(L, STACK_TABLE) != LUA_TNIL;
    }
    lua_pushinteger(L, position);
    lua_replace(L, lua_upvalueindex(UPVALUE_POSITION));
    if (!is_found) {
        lua_pushnil(L);
    }
    return is_found ? 2 : 1;
}

/** `pairs`. See lua_CFunction. @return 3: #next_of_pairs, the table, nil. */
static int ordered_pairs(lua_State *L) {
    luaL_checktype(L, STACK_TABLE, LUA_TTABLE);
    KeyCount count = count_keys(L, STACK_TABLE);
    if (count.is_list) {
        lua_pushnil(L);
    } else {
        push_sorted_keys(L, STACK_TABLE, &count);
    }
    lua_pushinteger(L, count.all);
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, next_of_pairs, UPVALUES);
    lua_pushvalue(L, STACK_TABLE);
    lua_pushnil(L);
    return 3;
}

// --- next ----------------------------------------------------------------------------------------

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
 * Finds the first key of a table, by a search of all keys.
 * @param L  The state; the key is pushed, or nil.
 */
static void push_first_key(lua_State *L) {
    const int best = STACK_KEY + 1, key = STACK_KEY + 2;
    SortKey least = {.rank = RANK_UNORDERED};
    lua_Integer unordered = 0;
    lua_settop(L, best);
    lua_pushnil(L);
    while (lua_next(L, STACK_TABLE)) {
        lua_pop(L, 1);
        const SortKey candidate = sort_key_of(L, key);
        unordered += candidate.rank == RANK_UNORDERED;
        if (lua_isnil(L, best) || compare_keys(&candidate, &least) < 0) {
            least = candidate;
            lua_copy(L, key, best);
        }
    }
    if (least.rank == RANK_UNORDERED && unordered > 1) {
        fail_unordered(L);
    }
}

/** Pushes the tables that `next` walks through. They may be collected meanwhile. */
static void push_walked_tables(lua_State *L) {
    registry_table_push(L, &walked_tables, true);
}

/** Sets or forgets the sorted keys of the table, which are on top of the stack, or nil. */
static void set_walked_keys(lua_State *L) {
    push_walked_tables(L);
    lua_pushvalue(L, STACK_TABLE);
    lua_pushvalue(L, -3);
    lua_rawset(L, -3);
    lua_pop(L, 1);
}

/** Pushes the sorted keys of the table, as they were when the walk began. */
static void push_walked_keys(lua_State *L) {
    push_walked_tables(L);
    lua_pushvalue(L, STACK_TABLE);
    if (lua_rawget(L, -2) != LUA_TTABLE) {
        lua_pop(L, 1);
        KeyCount count = count_keys(L, STACK_TABLE);
        push_sorted_keys(L, STACK_TABLE, &count);
        set_walked_keys(L);
    }
}

/**
 * Finds the place of the current key among the sorted keys, or of the next one if it was removed.
 * @param L      The state.
 * @param keys   Stack index of the sorted keys.
 * @param count  Their number.
 * @return Number of keys that do not follow it.
 */
static lua_Integer find_place(lua_State *L, int keys, lua_Integer count) {
    const SortKey key = sort_key_of(L, STACK_KEY);
    lua_Integer low = 0, high = count;
    while (low < high) {
        lua_Integer middle = low + (high - low) / 2;
        lua_rawgeti(L, keys, middle + 1);
        const SortKey other = sort_key_of(L, -1);
        lua_pop(L, 1); // The list keeps it.
        if (compare_keys(&other, &key) <= 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

/**
 * Finds the key after the current one among the sorted keys.
 * @param L  The state; the key is pushed, or nil at the end.
 */
static void push_next_key(lua_State *L) {
    push_walked_keys(L);
    const int keys = lua_gettop(L);
    const lua_Integer count = (lua_Integer)lua_rawlen(L, keys);
    lua_Integer place = find_place(L, keys, count);
    bool is_found = false;
    while (place < count && !is_found) {
        lua_settop(L, keys);
        lua_rawgeti(L, keys, ++place);
        lua_pushvalue(L, -1);
        is_found = lua_rawget(L, STACK_TABLE) != LUA_TNIL;
        lua_pop(L, 1);
    }
    if (!is_found) {
        lua_pushnil(L);
        set_walked_keys(L);
    }
}

/**
 * `next`: from a table and a key to the next key and its value. See lua_CFunction.
 * @param L  The state.
 * @return 2, or 1 at the end: nil.
 */
static int ordered_next(lua_State *L) {
    luaL_checktype(L, STACK_TABLE, LUA_TTABLE);
    lua_settop(L, STACK_KEY);
    if (lua_isnil(L, STACK_KEY)) {
        lua_pushnil(L);
        set_walked_keys(L); // A new walk.
        push_first_key(L);
        lua_settop(L, STACK_KEY + 1);
    } else if (!find_next_integer(L)) {
        push_next_key(L);
    }
    if (lua_isnil(L, -1)) {
        return 1;
    }
    lua_pushvalue(L, -1);
    lua_rawget(L, STACK_TABLE);
    return 2;
}

void ordered_pairs_open(lua_State *L) {
    static const luaL_Reg functions[] = {
        {"next", ordered_next}, {"pairs", ordered_pairs}, {NULL, NULL}};
    luaL_setfuncs(L, functions, 0);
}
