/**
 * @file
 * @brief Distance fields in scene files.
 *
 * A field is a Lua userdata that contains the whole #Sdf. Fields are immutable: methods return new
 * ones.
 */
#include "script/sdf_binding.h"

#include "base/language.h"
#include "script/library.h"
#include "script/lua_error.h"
#include "script/read_parameters.h"
#include "script/sdf_function.h"

#include <lauxlib.h>
#include <string.h>

/** Name of the type in errors, and key of its metatable. */
static const char sdf_type_name[] = "distance field";

/** A function that combines fields. */
typedef struct SdfOperator {
    const char *name;         /**< Name in the table `distance`. */
    SdfCombination operation; /**< The combination. */
    int operand_maximum;      /**< Largest number of fields; 0: any. */
} SdfOperator;

/** All functions that combine fields. */
static const SdfOperator sdf_operators[] = {{"union", SDF_COMBINE_UNION, 0},
                                            {"intersection", SDF_COMBINE_INTERSECTION, 0},
                                            {"difference", SDF_COMBINE_DIFFERENCE, 2},
                                            {"smooth_union", SDF_COMBINE_SMOOTH_UNION, 2}};

const Sdf *sdf_binding_test(lua_State *L, int index) {
    return luaL_testudata(L, index, sdf_type_name);
}

/**
 * @return A new field on top of the stack, with memory for nodes.
 * @param L             The state.
 * @param instructions  Number of nodes.
 */
static Sdf *push_sdf(lua_State *L, int instructions) {
    Sdf *sdf = lua_newuserdatauv(L, sdf_size(instructions), 0);
    luaL_setmetatable(L, sdf_type_name);
    return sdf;
}

/** @return A field; raises an error for anything else. */
static const Sdf *check_sdf(lua_State *L, int index, const char *function_name) {
    const Sdf *sdf = sdf_binding_test(L, index);
    if (!sdf) {
        lua_error_tr(L, "%s takes distance fields, not %s", function_name, read_describe(L, index));
    }
    return sdf;
}

/**
 * Raises an error if a call has the wrong number of arguments.
 * @param L      The state.
 * @param count  The right number.
 * @param usage  The call with its arguments, for the error.
 */
static void check_argument_count(lua_State *L, int count, const char *usage) {
    if (lua_gettop(L) != count) {
        lua_error_tr(L, "this is called as %s", usage);
    }
}

/** Raises an error if an operation failed. */
static void check_success(lua_State *L, bool is_good, const Error *error) {
    if (!is_good) {
        lua_error_tr(L, "%s", error->message);
    }
}

/**
 * Creates a primitive. See lua_CFunction.
 * @param L  The state, with a table; the #SdfPrimitive is the first upvalue.
 * @return 1: the field.
 */
static int call_primitive(lua_State *L) {
    const SdfPrimitive *primitive = lua_touserdata(L, lua_upvalueindex(1));
    const Keyword *const keywords[] = {&primitive->keyword, NULL};
    uint64_t given;
    read_check_arguments(L, keywords, NULL);
    const void *values = read_fields(L, &primitive->keyword, &given);
    primitive->create(push_sdf(L, 1), values);
    return 1;
}

/** `distance.field(function(x, y, z, t) ... end)`. See lua_CFunction. @return 1: the field. */
static int call_field(lua_State *L) {
    check_argument_count(L, 1, "distance.field(function(x, y, z) ... end)");
    if (!lua_isfunction(L, 1)) {
        return lua_error_tr(L, "%s takes a function, not %s", "distance.field",
                            read_describe(L, 1));
    }
    sdf_function_push(L, 1);
    luaL_setmetatable(L, sdf_type_name);
    return 1;
}

/**
 * Combines fields. See lua_CFunction.
 * @param L  The state, with the fields, and a radius for the smooth union; the #SdfOperator is the
 *           first upvalue.
 * @return 1: the field.
 */
static int call_operator(lua_State *L) {
    const SdfOperator *op = lua_touserdata(L, lua_upvalueindex(1));
    bool is_smooth = op->operation == SDF_COMBINE_SMOOTH_UNION;
    int count = lua_gettop(L) - is_smooth;
    double radius = 0;
    Error error = {0};
    if (count < 1) {
        return lua_error_tr(L, "%s of nothing: it takes distance fields", op->name);
    }
    if (op->operand_maximum > 0 && count != op->operand_maximum) {
        return lua_error_tr(L,
                            is_smooth ? N_("%s takes two distance fields and a radius")
                                      : N_("%s takes two distance fields"),
                            op->name);
    }
    if (is_smooth) {
        read_value(L, count + 1, &sdf_radius_parameter, &radius);
    }
    const Sdf **operands = lua_newuserdatauv(L, (size_t)count * sizeof *operands, 0);
    for (int i = 0; i < count; i++) {
        operands[i] = check_sdf(L, i + 1, op->name);
    }
    int capacity = sdf_combined_capacity(operands, count);
    Sdf *sdf = push_sdf(L, capacity < SDF_NODES_MAXIMUM ? capacity : SDF_NODES_MAXIMUM);
    check_success(L, sdf_combine(sdf, op->operation, operands, count, radius, &error), &error);
    return 1;
}

/**
 * Transforms a field.
 * @param L          The state, with the field.
 * @param transform  The transform.
 * @return 1: the new field.
 */
static int apply_transform(lua_State *L, Transform *transform) {
    const Sdf *sdf = sdf_binding_test(L, 1);
    Error error = {0};
    bool is_good = transform_keyword.finish(transform, 0, &error);
    Sdf *transformed = push_sdf(L, sdf->node_count + 1);
    check_success(L, is_good && sdf_transform(transformed, sdf, transform, &error), &error);
    return 1;
}

/** @return The row of a field of #transform_keyword. @param name Name of the field. */
static const Parameter *transform_parameter(const char *name) {
    const Parameter *row = transform_keyword.parameters;
    while (strcmp(row->name, name) != 0) {
        row++;
    }
    return row;
}

/** `f:translate{x, y, z}`. See lua_CFunction. @return 1: the new field. */
static int call_translate(lua_State *L) {
    Transform transform = *(const Transform *)transform_keyword.defaults;
    check_argument_count(L, 2, "f:translate{x, y, z}");
    check_sdf(L, 1, "translate");
    read_value(L, 2, transform_parameter("translate"), &transform.translate);
    return apply_transform(L, &transform);
}

/** `f:rotate{x, y, z}`. See lua_CFunction. @return 1: the new field. */
static int call_rotate(lua_State *L) {
    Transform transform = *(const Transform *)transform_keyword.defaults;
    check_argument_count(L, 2, "f:rotate{x, y, z}");
    check_sdf(L, 1, "rotate");
    read_value(L, 2, transform_parameter("rotate"), &transform.rotate);
    return apply_transform(L, &transform);
}

/** `f:scale(s)`. See lua_CFunction. @return 1: the new field. */
static int call_scale(lua_State *L) {
    Transform transform = *(const Transform *)transform_keyword.defaults;
    double scale;
    check_argument_count(L, 2, "f:scale(s)");
    check_sdf(L, 1, "scale");
    read_value(L, 2, &sdf_scale_parameter, &scale);
    transform.scale = (Vec3d){scale, scale, scale};
    return apply_transform(L, &transform);
}

/** `f:round(r)`. See lua_CFunction. @return 1: the new field. */
static int call_round(lua_State *L) {
    double radius;
    check_argument_count(L, 2, "f:round(radius)");
    const Sdf *sdf = check_sdf(L, 1, "round");
    read_value(L, 2, &sdf_round_parameter, &radius);
    if (sdf->node_count >= SDF_NODES_MAXIMUM) {
        return lua_error_tr(L, "a field may be made of at most %d fields", SDF_NODES_MAXIMUM);
    }
    sdf_round(push_sdf(L, sdf->node_count + 1), sdf, radius);
    return 1;
}

/**
 * Removes `count` from the table of `repeat_every`.
 * @param L           The state; the table is the second argument. A table of the numbers alone is
 *                    pushed.
 * @param[out] count  The field; zero without it.
 */
static void read_repeat_count(lua_State *L, Vec3d *count) {
    if (!lua_istable(L, 2)) {
        lua_error_tr(L, "repeat_every takes {x, y, z}");
    }
    *count = (Vec3d){0, 0, 0};
    if (lua_getfield(L, 2, sdf_count_parameter.name) != LUA_TNIL) {
        read_value(L, lua_gettop(L), &sdf_count_parameter, count);
    }
    lua_newtable(L);
    lua_pushnil(L);
    while (lua_next(L, 2)) {
        bool is_count = lua_type(L, -2) == LUA_TSTRING &&
                        strcmp(lua_tostring(L, -2), sdf_count_parameter.name) == 0;
        lua_pushvalue(L, -2);
        lua_insert(L, -2);
        if (is_count) {
            lua_pop(L, 2);
        } else {
            lua_settable(L, -4);
        }
    }
}

/** `f:repeat_every{x, y, z, count = {i, j, k}}`. See lua_CFunction. @return 1: the new field. */
static int call_repeat(lua_State *L) {
    SdfRepetition repeat;
    Error error = {0};
    check_argument_count(L, 2, "f:repeat_every{x, y, z, count = {i, j, k}}");
    const Sdf *sdf = check_sdf(L, 1, "repeat_every");
    read_repeat_count(L, &repeat.count);
    read_value(L, lua_gettop(L), &sdf_period_parameter, &repeat.period);
    Sdf *repeated = push_sdf(L, sdf->node_count + 1);
    check_success(L, sdf_repeat(repeated, sdf, &repeat, &error), &error);
    return 1;
}

/** Methods of fields. */
static const luaL_Reg methods[] = {{"translate", call_translate}, {"rotate", call_rotate},
                                   {"scale", call_scale},         {"round", call_round},
                                   {"repeat_every", call_repeat}, {NULL, NULL}};

/** Creates the metatable of fields. */
static void open_methods(lua_State *L) {
    luaL_newmetatable(L, sdf_type_name);
    luaL_newlib(L, methods);
    library_make_strict(L, "field", ":");
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, false);
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 1);
}

void sdf_binding_open(lua_State *L) {
    open_methods(L);
    sdf_function_open(L);
    lua_newtable(L);
    lua_pushcfunction(L, call_field);
    lua_setfield(L, -2, "field");
    for (size_t i = 0; sdf_primitives[i]; i++) {
        lua_pushlightuserdata(L, (void *)(uintptr_t)sdf_primitives[i]);
        lua_pushcclosure(L, call_primitive, 1);
        lua_setfield(L, -2, strchr(sdf_primitives[i]->keyword.name, '.') + 1);
    }
    for (size_t i = 0; i < sizeof sdf_operators / sizeof *sdf_operators; i++) {
        lua_pushlightuserdata(L, (void *)(uintptr_t)&sdf_operators[i]);
        lua_pushcclosure(L, call_operator, 1);
        lua_setfield(L, -2, sdf_operators[i].name);
    }
    library_make_strict(L, "distance", ".");
    lua_setglobal(L, "distance");
}
