/**
 * @file
 * @brief Distance fields that a scene gives as a function.
 */
#include "script/sdf_function.h"

#include "base/language.h"
#include "script/lua_error.h"
#include "script/read_parameters.h"
#include "script/script_run.h"
#include "script/script_sandbox.h"

#include <lauxlib.h>
#include <libintl.h>
#include <lualib.h>
#include <stdio.h>
#include <string.h>

/** Name of the type in errors, and key of its metatable. */
static const char symbol_type_name[] = "coordinate";

/** Largest whole exponent of a power: it becomes products. */
enum { EXPONENT_MAXIMUM = 64 };
/** Points at which the function and its tape are compared. */
enum { CHECKS = 64 };
/** Largest difference between both, relative to their size: roundings differ. */
#define CHECK_TOLERANCE 1e-9

/** A number that depends on the point. Its user value is the tape. */
typedef struct SdfSymbol {
    SdfTape *tape; /**< The tape; owned by Lua. */
    int step;      /**< Its step. */
} SdfSymbol;

/* --- symbols ---------------------------------------------------------------------------------- */

/** @return The symbol at a stack index; NULL for another type. */
static const SdfSymbol *test_symbol(lua_State *L, int index) {
    return luaL_testudata(L, index, symbol_type_name);
}

/** Pushes a symbol. @param tape_index Stack index of its tape. @param step Its step; -1: the tape
 *  is full, which raises an error. */
static void push_symbol(lua_State *L, int tape_index, int step) {
    tape_index = lua_absindex(L, tape_index);
    if (step < 0) {
        lua_error_tr(L, "the function takes more than %d operations", SDF_TAPE_STEPS_MAXIMUM);
    }
    SdfSymbol *symbol = lua_newuserdatauv(L, sizeof *symbol, 1);
    *symbol = (SdfSymbol){lua_touserdata(L, tape_index), step};
    luaL_setmetatable(L, symbol_type_name);
    lua_pushvalue(L, tape_index);
    lua_setiuservalue(L, -2, 1);
}

/**
 * Pushes the tape of the symbols among the arguments of a call.
 * @return The tape; raises an error if it is closed, or if there are two.
 */
static SdfTape *push_tape(lua_State *L) {
    const int count = lua_gettop(L);
    const SdfSymbol *first = NULL;
    for (int i = 1; i <= count; i++) {
        const SdfSymbol *symbol = test_symbol(L, i);
        bool is_foreign =
            symbol && (!symbol->tape->is_open || (first && first->tape != symbol->tape));
        if (is_foreign) {
            lua_error_tr(L, "this number belongs to another field: x, y and z and what is computed "
                            "from them are known only inside their function");
        }
        if (symbol && !first) {
            first = symbol;
            lua_getiuservalue(L, i, 1);
            lua_insert(L, count + 1);
        }
    }
    lua_settop(L, count + 1);
    return first ? first->tape : NULL;
}

/** @return The step of an operand, a symbol or a number; raises an error for anything else. */
static int operand_step(lua_State *L, SdfTape *tape, int index) {
    const SdfSymbol *symbol = test_symbol(L, index);
    if (symbol) {
        return symbol->step;
    }
    if (lua_type(L, index) != LUA_TNUMBER) {
        lua_error_tr(L, "a function of a field computes with numbers, not with %s",
                     read_describe(L, index));
    }
    int step = sdf_tape_add_constant(tape, lua_tonumber(L, index));
    if (step < 0) {
        push_symbol(L, -1, step);
    }
    return step;
}

/** @return The step of an operation; -1 if the tape is full. An operand may be -1, too. */
static int add_step(SdfTape *tape, SdfTapeOp op, int a, int b) {
    return a < 0 || b < 0 ? -1 : sdf_tape_add(tape, op, a, b);
}

/* --- operators -------------------------------------------------------------------------------- */

/** An operator or a function of `math`. */
typedef struct SymbolFunction {
    const char *name; /**< Its name: that of a metamethod, or in `math`. */
    SdfTapeOp op;     /**< Its operation, if it is one. */
} SymbolFunction;

/** @return The first upvalue of a function, or the second: a #SymbolFunction. */
static const SymbolFunction *function_of(lua_State *L, int upvalue) {
    return lua_touserdata(L, lua_upvalueindex(upvalue));
}

/** An operator of two operands. See lua_CFunction. @return 1: the symbol. */
static int call_operator(lua_State *L) {
    SdfTape *tape = push_tape(L);
    int a = operand_step(L, tape, 1), b = operand_step(L, tape, 2);
    push_symbol(L, 3, add_step(tape, function_of(L, 1)->op, a, b));
    return 1;
}

/** `-a`. See lua_CFunction. @return 1: the symbol. */
static int call_negate(lua_State *L) {
    lua_settop(L, 1); // Lua passes the operand twice.
    SdfTape *tape = push_tape(L);
    int a = operand_step(L, tape, 1);
    push_symbol(L, 2, add_step(tape, SDF_TAPE_NEGATE, a, a));
    return 1;
}

/** `a // b`. See lua_CFunction. @return 1: the symbol. */
static int call_floor_divide(lua_State *L) {
    SdfTape *tape = push_tape(L);
    int a = operand_step(L, tape, 1), b = operand_step(L, tape, 2);
    int quotient = add_step(tape, SDF_TAPE_DIVIDE, a, b);
    push_symbol(L, 3, add_step(tape, SDF_TAPE_FLOOR, quotient, quotient));
    return 1;
}

/** @return A power by the binary digits of the exponent, highest first. */
static int integer_power(SdfTape *tape, int a, int exponent) {
    int bit = 1, power = a;
    while (bit <= exponent / 2) {
        bit *= 2;
    }
    for (bit /= 2; bit > 0; bit /= 2) {
        power = add_step(tape, SDF_TAPE_MULTIPLY, power, power);
        power = exponent & bit ? add_step(tape, SDF_TAPE_MULTIPLY, power, a) : power;
    }
    return power;
}

/** `a ^ b` for a whole or half b. See lua_CFunction. @return 1: the symbol. */
static int call_power(lua_State *L) {
    SdfTape *tape = push_tape(L);
    int a = operand_step(L, tape, 1);
    double exponent = fabs(lua_tonumber(L, 2)), whole = floor(exponent);
    bool is_valid = lua_type(L, 2) == LUA_TNUMBER && exponent <= EXPONENT_MAXIMUM &&
                    (exponent == whole || exponent == whole + 0.5);
    if (!is_valid) {
        return lua_error_tr(L,
                            "a power of a coordinate needs a whole or half exponent, from -%d to "
                            "%d",
                            EXPONENT_MAXIMUM, EXPONENT_MAXIMUM);
    }
    int one = sdf_tape_add_constant(tape, 1);
    int power = whole > 0 ? integer_power(tape, a, (int)whole) : one;
    if (exponent > whole) {
        int root = add_step(tape, SDF_TAPE_SQUARE_ROOT, a, a);
        power = whole > 0 ? add_step(tape, SDF_TAPE_MULTIPLY, power, root) : root;
    }
    power = lua_tonumber(L, 2) < 0 ? add_step(tape, SDF_TAPE_DIVIDE, one, power) : power;
    push_symbol(L, 3, power);
    return 1;
}

/** A comparison. See lua_CFunction. @return Never. */
static int call_comparison(lua_State *L) {
    return lua_error_tr(L, "a function of a field cannot compare coordinates: it is read once for "
                           "all points; use math.min, math.max and math.abs");
}

/** Any other use of a symbol. See lua_CFunction. @return Never. */
static int call_other(lua_State *L) {
    return lua_error_tr(L,
                        "a coordinate of a field has no value yet: it can only be computed with");
}

/** The operators of two operands. */
static const SymbolFunction operators[] = {{"__add", SDF_TAPE_ADD},
                                           {"__sub", SDF_TAPE_SUBTRACT},
                                           {"__mul", SDF_TAPE_MULTIPLY},
                                           {"__div", SDF_TAPE_DIVIDE},
                                           {"__mod", SDF_TAPE_MODULO}};

/** All other metamethods. */
static const luaL_Reg metamethods[] = {{"__unm", call_negate},
                                       {"__idiv", call_floor_divide},
                                       {"__pow", call_power},
                                       {"__lt", call_comparison},
                                       {"__le", call_comparison},
                                       {"__eq", call_comparison},
                                       {"__tostring", call_other},
                                       {"__concat", call_other},
                                       {"__len", call_other},
                                       {"__index", call_other},
                                       {"__newindex", call_other},
                                       {"__call", call_other},
                                       {"__band", call_other},
                                       {"__bor", call_other},
                                       {"__bxor", call_other},
                                       {"__bnot", call_other},
                                       {"__shl", call_other},
                                       {"__shr", call_other},
                                       {NULL, NULL}};

/** Creates the metatable of symbols. */
static void open_symbols(lua_State *L) {
    luaL_newmetatable(L, symbol_type_name);
    luaL_setfuncs(L, metamethods, 0);
    for (size_t i = 0; i < sizeof operators / sizeof *operators; i++) {
        lua_pushlightuserdata(L, (void *)(uintptr_t)&operators[i]);
        lua_pushcclosure(L, call_operator, 1);
        lua_setfield(L, -2, operators[i].name);
    }
    lua_pushboolean(L, false);
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 1);
}

/* --- math ------------------------------------------------------------------------------------- */

/** A function of `math` with one argument. See lua_CFunction. The first upvalue is Lua's own
 *  function. @return 1: the symbol, or what Lua's function returns. */
static int math_unary(lua_State *L) {
    if (!test_symbol(L, 1)) {
        return lua_tocfunction(L, lua_upvalueindex(1))(L);
    }
    lua_settop(L, 1);
    SdfTape *tape = push_tape(L);
    int a = operand_step(L, tape, 1);
    push_symbol(L, 2, add_step(tape, function_of(L, 2)->op, a, a));
    return 1;
}

/** @return Whether an argument of a call is a symbol. */
static bool has_symbol(lua_State *L) {
    bool has_any = false;
    for (int i = 1; i <= lua_gettop(L); i++) {
        has_any = has_any || test_symbol(L, i);
    }
    return has_any;
}

/** `math.min` and `math.max`. See #math_unary. @return 1: the symbol. */
static int math_extremum(lua_State *L) {
    if (!has_symbol(L)) {
        return lua_tocfunction(L, lua_upvalueindex(1))(L);
    }
    SdfTape *tape = push_tape(L);
    int count = lua_gettop(L) - 1, extremum = operand_step(L, tape, 1);
    for (int i = 2; i <= count; i++) {
        extremum = add_step(tape, function_of(L, 2)->op, extremum, operand_step(L, tape, i));
    }
    push_symbol(L, count + 1, extremum);
    return 1;
}

/** `math.ceil`. See #math_unary. @return 1: the symbol. */
static int math_ceil(lua_State *L) {
    if (!test_symbol(L, 1)) {
        return lua_tocfunction(L, lua_upvalueindex(1))(L);
    }
    lua_settop(L, 1);
    SdfTape *tape = push_tape(L);
    int a = operand_step(L, tape, 1);
    int below = add_step(tape, SDF_TAPE_NEGATE, a, a);
    below = add_step(tape, SDF_TAPE_FLOOR, below, below);
    push_symbol(L, 2, add_step(tape, SDF_TAPE_NEGATE, below, below));
    return 1;
}

/** A function of `math` that no tape has. See #math_unary. @return What Lua's function returns. */
static int math_other(lua_State *L) {
    if (has_symbol(L)) {
        return lua_error_tr(
            L,
            "math.%s cannot be part of a field; + - * / // %% ^ and math.abs, ceil, "
            "cos, floor, max, min, sin, sqrt can",
            function_of(L, 2)->name);
    }
    return lua_tocfunction(L, lua_upvalueindex(1))(L);
}

/** A function of `math` with its replacement. */
typedef struct MathFunction {
    SymbolFunction function; /**< Its name and its operation. */
    lua_CFunction call;      /**< The replacement. */
} MathFunction;

/** The functions of `math` that are replaced. */
static const MathFunction math_functions[] = {
    {{"abs", SDF_TAPE_ABSOLUTE}, math_unary},    {{"ceil", SDF_TAPE_FLOOR}, math_ceil},
    {{"cos", SDF_TAPE_COSINE}, math_unary},      {{"floor", SDF_TAPE_FLOOR}, math_unary},
    {{"max", SDF_TAPE_MAXIMUM}, math_extremum},  {{"min", SDF_TAPE_MINIMUM}, math_extremum},
    {{"sin", SDF_TAPE_SINE}, math_unary},        {{"sqrt", SDF_TAPE_SQUARE_ROOT}, math_unary},
    {{"acos", SDF_TAPE_INPUT}, math_other},      {{"asin", SDF_TAPE_INPUT}, math_other},
    {{"atan", SDF_TAPE_INPUT}, math_other},      {{"deg", SDF_TAPE_INPUT}, math_other},
    {{"exp", SDF_TAPE_INPUT}, math_other},       {{"fmod", SDF_TAPE_INPUT}, math_other},
    {{"log", SDF_TAPE_INPUT}, math_other},       {{"modf", SDF_TAPE_INPUT}, math_other},
    {{"rad", SDF_TAPE_INPUT}, math_other},       {{"tan", SDF_TAPE_INPUT}, math_other},
    {{"tointeger", SDF_TAPE_INPUT}, math_other}, {{"type", SDF_TAPE_INPUT}, math_other},
    {{"ult", SDF_TAPE_INPUT}, math_other}};

/** Replaces functions of `math`, which take symbols, too. */
static void open_math(lua_State *L) {
    lua_getglobal(L, LUA_MATHLIBNAME);
    for (size_t i = 0; i < sizeof math_functions / sizeof *math_functions; i++) {
        const MathFunction *row = &math_functions[i];
        lua_getfield(L, -1, row->function.name);
        lua_pushlightuserdata(L, (void *)(uintptr_t)&row->function);
        lua_pushcclosure(L, row->call, 2);
        lua_setfield(L, -2, row->function.name);
    }
    lua_pop(L, 1);
}

void sdf_function_open(lua_State *L) {
    open_symbols(L);
    open_math(L);
}

/* --- the function ----------------------------------------------------------------------------- */

/** @return The first line of a function; the current one if it is not in a file. */
static SourceLocation function_location(lua_State *L, int index) {
    lua_Debug debug;
    lua_pushvalue(L, index);
    lua_getinfo(L, ">S", &debug);
    int file = script_result_find_file(script_sandbox_of(L)->result, debug.short_src);
    return file >= 0 ? (SourceLocation){file, debug.linedefined} : script_sandbox_location(L);
}

/** Raises an error at the first line of a function. @param index Its stack index. @param message
 *  The message, translated. @return Never. */
static int function_error(lua_State *L, int index, const char *message) {
    SourceLocation location = function_location(L, index);
    lua_pushfstring(L, "%s:%d: %s",
                    script_sandbox_of(L)->result->files[location.file].chunk_name + 1,
                    location.line, message);
    return lua_error(L);
}

/**
 * Calls a function with x, y and z from the stack, and with the time if it takes it.
 * @param index  Stack index of the function; its arguments are the three values on top.
 */
static void call_function(lua_State *L, int index) {
    const ScriptRun *run = script_sandbox_of(L)->context;
    lua_Debug debug;
    lua_pushvalue(L, index);
    lua_getinfo(L, ">u", &debug);
    bool takes_time = debug.nparams > 3;
    run->scene->is_time_dependent = run->scene->is_time_dependent || takes_time;
    lua_pushvalue(L, index);
    lua_insert(L, -4);
    if (takes_time) {
        lua_pushnumber(L, run->request->time);
    }
    lua_call(L, takes_time ? 4 : 3, 1);
}

/** @return A random number, -4 to 4, by splitmix64. */
static double random_coordinate(uint64_t *state) {
    uint64_t bits = *state += 0x9e3779b97f4a7c15u;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9u;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebu;
    return (double)((bits ^ (bits >> 31)) >> 11) * 0x1p-50 - 4;
}

/** Raises an error if a function and its tape differ, which they do if it depends on anything but
 *  the point. The first points have whole coordinates. */
static void check_values(lua_State *L, int index, const Sdf *field) {
    uint64_t state = 1;
    for (int i = 0; i < CHECKS; i++) {
        Vec3d p = i < 27 ? (Vec3d){i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1}
                         : (Vec3d){random_coordinate(&state), random_coordinate(&state),
                                   random_coordinate(&state)};
        lua_pushnumber(L, p.x);
        lua_pushnumber(L, p.y);
        lua_pushnumber(L, p.z);
        call_function(L, index);
        double wanted = lua_tonumber(L, -1), value = sdf_tape_value(field->nodes, p);
        bool is_equal = lua_type(L, -1) == LUA_TNUMBER &&
                        (fabs(value - wanted) <= CHECK_TOLERANCE * (1 + fabs(wanted)) ||
                         wanted == value || (isnan(wanted) && isnan(value)));
        if (!is_equal) {
            char message[ERROR_MESSAGE_SIZE];
            snprintf(
                message, sizeof message,
                gettext("at (%g, %g, %g) the function says %g, but %g when it was read: it must "
                        "compute the same for all points, without ==, random numbers or "
                        "memory"),
                p.x, p.y, p.z, wanted, value);
            function_error(L, index, message);
        }
        lua_pop(L, 1);
    }
}

/** Adds a note to the scene. @param index Stack index of the function that it is about. */
static void add_note(lua_State *L, int index, const char *message) {
    const ScriptSandbox *sandbox = script_sandbox_of(L);
    char note[2 * ERROR_MESSAGE_SIZE];
    Error error = {0};
    SourceLocation location = function_location(L, index);
    script_result_format_location(sandbox->result, location, note, ERROR_MESSAGE_SIZE);
    size_t length = strlen(note);
    snprintf(note + length, sizeof note - length, ": %s", message);
    if (!scene_add_note(((ScriptRun *)sandbox->context)->scene, note, &error)) {
        lua_error_tr(L, "%s", error.message);
    }
}

/** Divides a tape by its slope, so that it is a distance, and adds notes about it. */
static void correct_slope(lua_State *L, int index, Sdf *field) {
    const SdfTapeSlope found = sdf_tape_normalize(field);
    const double factor = field->nodes[0].operands[SDF_TAPE_FACTOR];
    char message[ERROR_MESSAGE_SIZE];
    if (!found.is_number) {
        add_note(
            L, index,
            gettext("this field is a number at none of the points that were tried, so rays find "
                    "no surface: the root of a number below 0, or a division by 0?"));
    }
    if (factor != 1) {
        snprintf(message, sizeof message,
                 gettext("this field grows by %.3g per unit at (%.3g, %.3g, %.3g), so it is no "
                         "distance; it is divided by %.3g"),
                 found.slope, found.from.x, found.from.y, found.from.z, 1 / factor);
        add_note(L, index, message);
    }
    if (found.jump > 0) {
        snprintf(message, sizeof message,
                 gettext("this field jumps by %.3g at (%.3g, %.3g, %.3g), so it is no distance: "
                         "rays may step over its surface"),
                 found.jump, found.jump_at.x, found.jump_at.y, found.jump_at.z);
        add_note(L, index, message);
    }
}

Sdf *sdf_function_push(lua_State *L, int index) {
    index = lua_absindex(L, index);
    SdfTape *tape = lua_newuserdatauv(L, sizeof *tape, 0);
    int tape_index = lua_gettop(L);
    sdf_tape_begin(tape);
    for (int axis = 0; axis < 3; axis++) {
        push_symbol(L, tape_index, axis);
    }
    call_function(L, index);
    const SdfSymbol *result = test_symbol(L, -1);
    if (!result || result->tape != tape) {
        char message[ERROR_MESSAGE_SIZE];
        snprintf(message, sizeof message,
                 gettext("the function of a field must return a number that depends on x, y or z, "
                         "not %s"),
                 read_describe(L, lua_gettop(L)));
        function_error(L, index, message);
        return NULL;
    }
    Error error = {0};
    Sdf *field = lua_newuserdatauv(L, sdf_size(1 + tape->count), 0);
    if (!sdf_from_tape(field, tape, result->step, &error)) {
        function_error(L, index, error.message);
    }
    check_values(L, index, field);
    if (!sdf_tape_find_bounds(field)) {
        function_error(L, index, gettext("the function is above 0 everywhere: it has no surface"));
    }
    correct_slope(L, index, field);
    lua_insert(L, tape_index);
    lua_settop(L, tape_index);
    return field;
}
