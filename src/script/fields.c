/**
 * @file
 * @brief Distance fields in scene files.
 *
 * A field is a userdata of Lua that holds the whole #Field. None is ever changed: what a method
 * returns is a new one.
 */
#include "script/fields.h"

#include "dioptre/language.h"
#include "script/library.h"
#include "script/raise.h"
#include "script/read.h"

#include <lauxlib.h>
#include <string.h>

/** What fields are called in errors, and what marks them. */
static const char field_name[] = "distance field";

/** What a join is called in a scene file. */
typedef struct JoinWord {
    const char *name; /**< In `distance`. */
    FieldJoin join;   /**< Which it is. */
    int most;         /**< Most fields that it takes; 0: any number. */
} JoinWord;

/** All joins. */
static const JoinWord join_words[] = {{"union", FIELD_JOIN_UNION, 0},
                                      {"intersection", FIELD_JOIN_INTERSECTION, 0},
                                      {"difference", FIELD_JOIN_DIFFERENCE, 2},
                                      {"smooth_union", FIELD_JOIN_SMOOTH, 2}};

const Field *fields_test(lua_State *L, int index) {
    return luaL_testudata(L, index, field_name);
}

/** @return A new field on top of the stack, with room for steps. @param L The state.
 *  @param steps How many. */
static Field *push_field(lua_State *L, int steps) {
    Field *field = lua_newuserdatauv(L, field_size(steps), 0);
    luaL_setmetatable(L, field_name);
    return field;
}

/** @return A field; raises an error about anything else. @param L The state. @param index Where it
 *  is. @param word Who wants it. */
static const Field *check_field(lua_State *L, int index, const char *word) {
    const Field *field = fields_test(L, index);
    if (!field) {
        raise_error(L, "%s takes distance fields, not %s", word, read_describe(L, index));
    }
    return field;
}

/** Raises an error unless a call has a number of values. @param L The state. @param count How many.
 *  @param usage How it is called. */
static void check_count(lua_State *L, int count, const char *usage) {
    if (lua_gettop(L) != count) {
        raise_error(L, "this is called as %s", usage);
    }
}

/** Raises an error unless something went well. @param L The state. @param is_good Whether it did.
 *  @param error What is wrong. */
static void check_good(lua_State *L, bool is_good, const Error *error) {
    if (!is_good) {
        raise_error(L, "%s", error->message);
    }
}

/** Makes a field of numbers. See lua_CFunction. @param L The state, with a table; the #FieldKind is
 *  the first upvalue. @return 1: the field. */
static int call_kind(lua_State *L) {
    const FieldKind *kind = lua_touserdata(L, lua_upvalueindex(1));
    const Keyword *const keywords[] = {&kind->keyword, NULL};
    uint64_t given;
    read_check_names(L, keywords, NULL);
    const void *values = read_fields(L, &kind->keyword, &given);
    kind->make(push_field(L, 1), values);
    return 1;
}

/** Makes one field of several. See lua_CFunction. @param L The state, with the fields, and for the
 *  smooth union a radius; the #JoinWord is the first upvalue. @return 1: the field. */
static int call_join(lua_State *L) {
    const JoinWord *word = lua_touserdata(L, lua_upvalueindex(1));
    bool is_smooth = word->join == FIELD_JOIN_SMOOTH;
    int count = lua_gettop(L) - is_smooth;
    double radius = 0;
    Error error = {0};
    if (count < 1) {
        return raise_error(L, "%s of nothing: it takes distance fields", word->name);
    }
    if (word->most > 0 && count != word->most) {
        return raise_error(L,
                           is_smooth ? N_("%s takes two distance fields and a radius")
                                     : N_("%s takes two distance fields"),
                           word->name);
    }
    if (is_smooth) {
        read_value(L, count + 1, &field_radius_row, &radius);
    }
    const Field **fields = lua_newuserdatauv(L, (size_t)count * sizeof *fields, 0);
    for (int i = 0; i < count; i++) {
        fields[i] = check_field(L, i + 1, word->name);
    }
    int room = field_room(fields, count);
    Field *joined = push_field(L, room < FIELD_STEPS_MAXIMUM ? room : FIELD_STEPS_MAXIMUM);
    check_good(L, field_join(joined, word->join, fields, count, radius, &error), &error);
    return 1;
}

/**
 * Scales, turns or moves a field.
 * @param L          The state, with the field.
 * @param transform  How; finished here.
 * @return 1: the new field.
 */
static int place(lua_State *L, Transform *transform) {
    const Field *field = fields_test(L, 1);
    Error error = {0};
    bool is_good = transform_keyword.finish(transform, 0, &error);
    Field *placed = push_field(L, field->count + 1);
    check_good(L, is_good && field_place(placed, field, transform, &error), &error);
    return 1;
}

/** @return The row of a field of every shape. @param name Its name. */
static const Parameter *transform_row(const char *name) {
    const Parameter *row = transform_keyword.parameters;
    while (strcmp(row->name, name) != 0) {
        row++;
    }
    return row;
}

/** `f:translate{x, y, z}`. See lua_CFunction. @param L The state. @return 1: the new field. */
static int call_translate(lua_State *L) {
    Transform transform = *(const Transform *)transform_keyword.defaults;
    check_count(L, 2, "f:translate{x, y, z}");
    check_field(L, 1, "translate");
    read_value(L, 2, transform_row("translate"), &transform.translate);
    return place(L, &transform);
}

/** `f:rotate{x, y, z}`. See lua_CFunction. @param L The state. @return 1: the new field. */
static int call_rotate(lua_State *L) {
    Transform transform = *(const Transform *)transform_keyword.defaults;
    check_count(L, 2, "f:rotate{x, y, z}");
    check_field(L, 1, "rotate");
    read_value(L, 2, transform_row("rotate"), &transform.rotate);
    return place(L, &transform);
}

/** `f:scale(s)`. See lua_CFunction. @param L The state. @return 1: the new field. */
static int call_scale(lua_State *L) {
    Transform transform = *(const Transform *)transform_keyword.defaults;
    double scale;
    check_count(L, 2, "f:scale(s)");
    check_field(L, 1, "scale");
    read_value(L, 2, &field_scale_row, &scale);
    transform.scale = (Vector3){scale, scale, scale};
    return place(L, &transform);
}

/** `f:round(r)`. See lua_CFunction. @param L The state. @return 1: the new field. */
static int call_round(lua_State *L) {
    double radius;
    check_count(L, 2, "f:round(radius)");
    const Field *field = check_field(L, 1, "round");
    read_value(L, 2, &field_round_row, &radius);
    if (field->count >= FIELD_STEPS_MAXIMUM) {
        return raise_error(L, "a field may be made of %d at most", FIELD_STEPS_MAXIMUM);
    }
    field_round(push_field(L, field->count + 1), field, radius);
    return 1;
}

/** Takes `count` out of the table of `repeat_every`, which has it beside three numbers.
 *  @param L The state, with the table as second value; afterwards a table of the numbers alone is
 * on top. @param[out] count It; zero if it is not there. */
static void read_copies(lua_State *L, Vector3 *count) {
    if (!lua_istable(L, 2)) {
        raise_error(L, "repeat_every takes {x, y, z}");
    }
    *count = (Vector3){0, 0, 0};
    if (lua_getfield(L, 2, field_count_row.name) != LUA_TNIL) {
        read_value(L, lua_gettop(L), &field_count_row, count);
    }
    lua_newtable(L);
    lua_pushnil(L);
    while (lua_next(L, 2)) {
        bool is_count = lua_type(L, -2) == LUA_TSTRING &&
                        strcmp(lua_tostring(L, -2), field_count_row.name) == 0;
        lua_pushvalue(L, -2);
        lua_insert(L, -2);
        if (is_count) {
            lua_pop(L, 2);
        } else {
            lua_settable(L, -4);
        }
    }
}

/** `f:repeat_every{x, y, z, count = {i, j, k}}`. See lua_CFunction. @param L The state.
 *  @return 1: the new field. */
static int call_repeat(lua_State *L) {
    FieldRepeat repeat;
    Error error = {0};
    check_count(L, 2, "f:repeat_every{x, y, z, count = {i, j, k}}");
    const Field *field = check_field(L, 1, "repeat_every");
    read_copies(L, &repeat.count);
    read_value(L, lua_gettop(L), &field_period_row, &repeat.period);
    Field *repeated = push_field(L, field->count + 1);
    check_good(L, field_repeat(repeated, field, &repeat, &error), &error);
    return 1;
}

/** What fields can do. */
static const luaL_Reg methods[] = {{"translate", call_translate}, {"rotate", call_rotate},
                                   {"scale", call_scale},         {"round", call_round},
                                   {"repeat_every", call_repeat}, {NULL, NULL}};

/** Makes what all fields share. @param L The state. */
static void open_methods(lua_State *L) {
    luaL_newmetatable(L, field_name);
    luaL_newlib(L, methods);
    library_make_strict(L, "field", ":");
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, false);
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 1);
}

void fields_open(lua_State *L) {
    open_methods(L);
    lua_newtable(L);
    for (size_t i = 0; field_kinds[i]; i++) {
        lua_pushlightuserdata(L, (void *)(uintptr_t)field_kinds[i]);
        lua_pushcclosure(L, call_kind, 1);
        lua_setfield(L, -2, strchr(field_kinds[i]->keyword.name, '.') + 1);
    }
    for (size_t i = 0; i < sizeof join_words / sizeof *join_words; i++) {
        lua_pushlightuserdata(L, (void *)(uintptr_t)&join_words[i]);
        lua_pushcclosure(L, call_join, 1);
        lua_setfield(L, -2, join_words[i].name);
    }
    library_make_strict(L, "distance", ".");
    lua_setglobal(L, "distance");
}
