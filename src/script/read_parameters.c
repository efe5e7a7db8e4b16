/**
 * @file
 * @brief Conversion of Lua tables to C structs by parameter tables.
 */
#include "script/read_parameters.h"

#include "base/language.h"
#include "base/suggest.h"
#include "script/hex_color.h"
#include "script/lua_error.h"
#include "script/script_run.h"
#include "script/script_sandbox.h"
#include "script/sdf_binding.h"
#include "script/sdf_function.h"

#include <lauxlib.h>
#include <libintl.h>
#include <string.h>

const char *read_describe(lua_State *L, int index) {
    static const char *const type_names[LUA_NUMTYPES] = {
        [LUA_TNIL] = N_("nothing"),       [LUA_TBOOLEAN] = N_("a boolean"),
        [LUA_TNUMBER] = N_("a number"),   [LUA_TSTRING] = N_("a string"),
        [LUA_TTABLE] = N_("a table"),     [LUA_TFUNCTION] = N_("a function"),
        [LUA_TTHREAD] = N_("a coroutine")};
    int type = lua_type(L, index);
    const char *description = type == LUA_TNONE ? type_names[LUA_TNIL] : type_names[type];
    if (sdf_binding_test(L, index)) {
        description = N_("a distance field");
    }
    if (description) {
        return lua_pushstring(L, gettext(description));
    }
    // References to parts of the scene have the name of their keyword.
    bool is_named = luaL_getmetafield(L, index, "__name") == LUA_TSTRING;
    const char *name = is_named ? lua_tostring(L, -1) : "userdata";
    return lua_pushfstring(L, gettext(strchr("aeiou", name[0]) ? N_("an %s") : N_("a %s")), name);
}

void read_type_error(lua_State *L, int index, const Parameter *row, const char *expected) {
    lua_error_tr(L, "%s must be %s, not %s", row->name, gettext(expected), read_describe(L, index));
}

/**
 * @return A number, finite and in range; raises an error for any other.
 * @param L      The state.
 * @param index  Stack index of the number.
 * @param row    Row of the parameter table.
 */
static double read_number_in_range(lua_State *L, int index, const Parameter *row) {
    Error error = {0};
    double value = lua_tonumber(L, index);
    if (!parameter_check_range(row, value, &error)) {
        lua_error_tr(L, "%s", error.message);
    }
    return value;
}

/** @return A hint for numbers that a decimal comma has cut in two, translated. */
static const char *decimal_point_hint(void) {
    return gettext("; a decimal number has a point: 0.5, not 0,5");
}

/** Format of a list of numbers. */
typedef struct NumberList {
    int count;            /**< Number of numbers. */
    const char *expected; /**< Description, for errors. */
} NumberList;

/** `{x, y, z}` */
static const NumberList vector_list = {3, N_("three numbers {x, y, z}")};
/** `{x, y, z}` or one number. */
static const NumberList scale_list = {3, N_("one number, or three numbers {x, y, z}")};
/** `{u, v}` */
static const NumberList pair_list = {2, N_("two numbers {u, v}")};
/** `{red, green, blue}`, one number or a string. */
static const NumberList color_list = {
    3, N_("a colour ({red, green, blue}, one number, or \"#rrggbb\")")};

/** @return Number of entries of a table. @param L The state. @param index Its stack index. */
static lua_Integer count_entries(lua_State *L, int index) {
    lua_Integer count = 0;
    lua_pushnil(L);
    while (lua_next(L, index)) {
        lua_pop(L, 1);
        count++;
    }
    return count;
}

/**
 * Reads `{a, b, c}`; raises an error for anything else.
 * @param L             The state.
 * @param index         Stack index of the value, of any type.
 * @param row           Row of the parameter table.
 * @param list          The format.
 * @param[out] numbers  The numbers, each in range.
 */
static void read_list(lua_State *L, int index, const Parameter *row, const NumberList *list,
                      double *numbers) {
    if (!lua_istable(L, index)) {
        read_type_error(L, index, row, list->expected);
    }
    lua_Integer count = count_entries(L, index);
    if (count > 0 && lua_rawlen(L, index) == 0) {
        lua_error_tr(L, "%s must be %s: the numbers alone, without names", row->name,
                     gettext(list->expected));
    }
    // Lengths are checked before ranges: {0,5} has one number too few, and none is too large.
    bool is_complete = count <= list->count;
    for (int i = 0; i < list->count; i++) {
        is_complete = lua_geti(L, index, i + 1) != LUA_TNIL && is_complete;
        lua_pop(L, 1);
    }
    if (!is_complete) {
        const char *message = ngettext("%s must be %s; there is %lld thing between the braces%s",
                                       "%s must be %s; there are %lld things between the braces%s",
                                       (unsigned long)count);
        lua_error_tr(L, message, row->name, gettext(list->expected), (long long)count,
                     count > 1 ? decimal_point_hint() : "");
    }
    for (int i = 0; i < list->count; i++) {
        if (lua_geti(L, index, i + 1) != LUA_TNUMBER) {
            lua_error_tr(L, "%s must be %s; number %d of them is %s", row->name,
                         gettext(list->expected), i + 1, read_describe(L, lua_gettop(L)));
        }
        numbers[i] = read_number_in_range(L, -1, row);
        lua_pop(L, 1);
    }
}

/** Reads a `double`. See #ReadFunction. */
static void read_number(lua_State *L, int index, const Parameter *row, void *field) {
    if (lua_type(L, index) != LUA_TNUMBER) {
        read_type_error(L, index, row, N_("a number"));
    }
    *(double *)field = read_number_in_range(L, index, row);
}

/** Reads an `int`. See #ReadFunction. */
static void read_integer(lua_State *L, int index, const Parameter *row, void *field) {
    double value;
    read_number(L, index, row, &value);
    if (value != floor(value)) {
        lua_error_tr(L, "%s must be a whole number, not %.14g", row->name, value);
    }
    *(int *)field = (int)value;
}

/** Reads a `bool`. See #ReadFunction. */
static void read_boolean(lua_State *L, int index, const Parameter *row, void *field) {
    if (!lua_isboolean(L, index)) {
        read_type_error(L, index, row, N_("true or false"));
    }
    *(bool *)field = lua_toboolean(L, index);
}

/**
 * Pushes the words of a row for an error: `` `none` or `inverse_square` ``.
 * @param L      The state.
 * @param words  The words, ended by NULL; at least one.
 * @return The text, valid while it is on the stack.
 */
static const char *list_words(lua_State *L, const char *const *words) {
    luaL_Buffer list;
    luaL_buffinit(L, &list);
    for (size_t i = 0; words[i]; i++) {
        const char *separator = i == 0 ? "" : words[i + 1] ? ", " : gettext(" or ");
        luaL_addstring(&list, separator);
        luaL_addchar(&list, '`');
        luaL_addstring(&list, words[i]);
        luaL_addchar(&list, '`');
    }
    luaL_pushresult(&list);
    return lua_tostring(L, -1);
}

/** Reads a word as its index in #Parameter.choices. See #ReadFunction. */
static void read_word(lua_State *L, int index, const Parameter *row, void *field) {
    if (lua_type(L, index) != LUA_TSTRING) {
        read_type_error(L, index, row, list_words(L, row->choices));
    }
    Suggestion suggestion = {.word = lua_tostring(L, index)};
    for (int i = 0; row->choices[i]; i++) {
        if (strcmp(row->choices[i], suggestion.word) == 0) {
            *(int *)field = i;
            return;
        }
        suggest_try(&suggestion, row->choices[i]);
    }
    char hint[SUGGEST_HINT_SIZE];
    lua_error_tr(L, "%s must be %s, not `%s`%s", row->name, list_words(L, row->choices),
                 suggestion.word, suggest_hint(&suggestion, hint));
}

/** Reads a `Vec3d`. See #ReadFunction. */
static void read_vector(lua_State *L, int index, const Parameter *row, void *field) {
    double xyz[3];
    read_list(L, index, row, &vector_list, xyz);
    *(Vec3d *)field = (Vec3d){xyz[0], xyz[1], xyz[2]};
}

/** Reads a `Vec3d` that may be one number. See #ReadFunction. */
static void read_scale(lua_State *L, int index, const Parameter *row, void *field) {
    double xyz[3];
    if (lua_type(L, index) == LUA_TNUMBER) {
        xyz[0] = xyz[1] = xyz[2] = read_number_in_range(L, index, row);
    } else {
        read_list(L, index, row, &scale_list, xyz);
    }
    *(Vec3d *)field = (Vec3d){xyz[0], xyz[1], xyz[2]};
}

/** Reads a `Uvd`. See #ReadFunction. */
static void read_pair(lua_State *L, int index, const Parameter *row, void *field) {
    double uv[2];
    read_list(L, index, row, &pair_list, uv);
    *(Uvd *)field = (Uvd){uv[0], uv[1]};
}

/** Reads a `Vec3d` that is not zero. See #ReadFunction. */
static void read_direction(lua_State *L, int index, const Parameter *row, void *field) {
    Vec3d direction;
    read_vector(L, index, row, &direction);
    if (!(vec3d_length(direction) > 0)) {
        lua_error_tr(L, "%s must not be zero: it says a direction", row->name);
    }
    *(Vec3d *)field = direction;
}

/**
 * Reads a colour given as text.
 * @param L      The state.
 * @param index  Stack index of the string.
 * @param row    Row of the parameter table.
 * @return The colour, in range.
 */
static Rgbd read_hex_color(lua_State *L, int index, const Parameter *row) {
    size_t length;
    const char *text = lua_tolstring(L, index, &length);
    Rgbd color = {0};
    if (!hex_color_read(text, length, &color)) {
        lua_error_tr(L, "%s must be a colour such as \"#ff8000\", not \"%s\"", row->name, text);
    }
    const double parts[] = {color.red, color.green, color.blue};
    for (int i = 0; i < 3; i++) {
        lua_pushnumber(L, parts[i]);
        read_number_in_range(L, -1, row);
        lua_pop(L, 1);
    }
    return color;
}

/** Reads a `Rgbd`. See #ReadFunction. */
static void read_color(lua_State *L, int index, const Parameter *row, void *field) {
    double rgb[3];
    int type = lua_type(L, index);
    if (type == LUA_TSTRING) {
        *(Rgbd *)field = read_hex_color(L, index, row);
    } else if (type == LUA_TNUMBER) {
        double grey = read_number_in_range(L, index, row);
        *(Rgbd *)field = (Rgbd){grey, grey, grey};
    } else {
        read_list(L, index, row, &color_list, rgb);
        *(Rgbd *)field = (Rgbd){rgb[0], rgb[1], rgb[2]};
    }
}

/** Reads a distance field or the function of one; the scene keeps a copy. See #ReadFunction. */
static void read_field(lua_State *L, int index, const Parameter *row, void *field) {
    const Sdf *sdf =
        lua_isfunction(L, index) ? sdf_function_push(L, index) : sdf_binding_test(L, index);
    Error error = {0};
    if (!sdf) {
        read_type_error(L, index, row, N_("a distance field"));
    }
    const Sdf *kept =
        scene_add_sdf(((ScriptRun *)script_sandbox_of(L)->context)->scene, sdf, &error);
    if (!kept) {
        lua_error_tr(L, "%s", error.message);
    }
    *(const Sdf **)field = kept;
}

/** Type of functions that read a value of one type; see #read_value. */
typedef void ReadFunction(lua_State *L, int index, const Parameter *row, void *field);

void read_value(lua_State *L, int index, const Parameter *row, void *field) {
    static ReadFunction *const readers[] = {[PARAMETER_NUMBER] = read_number,
                                            [PARAMETER_INTEGER] = read_integer,
                                            [PARAMETER_BOOLEAN] = read_boolean,
                                            [PARAMETER_CHOICE] = read_word,
                                            [PARAMETER_POINT] = read_vector,
                                            [PARAMETER_VECTOR] = read_vector,
                                            [PARAMETER_DIRECTION] = read_direction,
                                            [PARAMETER_SCALE] = read_scale,
                                            [PARAMETER_UV] = read_pair,
                                            [PARAMETER_COLOR] = read_color,
                                            [PARAMETER_MESH] = read_mesh_name,
                                            [PARAMETER_SDF] = read_field,
                                            [PARAMETER_TEXTURE] = read_texture_name};
    readers[row->type](L, index, row, field);
}

/**
 * Searches a field in keywords.
 * @param keywords            The keywords whose fields are valid in the table, ended by NULL.
 * @param nested              A keyword whose name is a further valid field; NULL: none.
 * @param[in,out] suggestion  The name of the field; if it is unknown, the nearest one is recorded.
 * @return Whether one has it.
 */
static bool has_field(const Keyword *const *keywords, const Keyword *nested,
                      Suggestion *suggestion) {
    for (; *keywords; keywords++) {
        for (const Parameter *row = (*keywords)->parameters; row->name; row++) {
            if (strcmp(row->name, suggestion->word) == 0) {
                return true;
            }
            suggest_try(suggestion, row->name);
        }
    }
    if (nested) {
        suggest_try(suggestion, nested->name);
    }
    return nested && strcmp(nested->name, suggestion->word) == 0;
}

/** Raises an error for a field that the table cannot have. @param nested See #has_field. */
static void raise_unknown_field(lua_State *L, const char *name, const Keyword *nested,
                                const Suggestion *unknown) {
    const Keyword *const nested_only[] = {nested, NULL};
    Suggestion within = {.word = unknown->word};
    bool is_nested = nested && has_field(nested_only, NULL, &within);
    const char *meant = is_nested ? unknown->word : within.best_match;
    if (meant && (is_nested || !unknown->best_match)) {
        lua_error_tr(L, "%s has no field `%s`; did you mean `%s = %s { %s = ... }`?", name,
                     unknown->word, nested->name, nested->name, meant);
    }
    char hint[SUGGEST_HINT_SIZE];
    lua_error_tr(L, "%s has no field `%s`%s", name, unknown->word, suggest_hint(unknown, hint));
}

/**
 * @return Whether the key on top of the stack is 1, and the keyword's first field needs no name.
 */
static bool is_positional_key(lua_State *L, const Keyword *keyword) {
    return keyword_has_field(keyword) && lua_isinteger(L, -1) && lua_tointeger(L, -1) == 1;
}

/**
 * Pushes a field of the table.
 * @param L        The state; the table is the first argument.
 * @param keyword  The keyword.
 * @param i        Index of the row of the field.
 * @return Whether the table has it.
 */
static bool push_field(lua_State *L, const Keyword *keyword, int i) {
    bool is_named = lua_getfield(L, 1, keyword->parameters[i].name) != LUA_TNIL;
    if (i > 0 || !keyword_has_field(keyword)) {
        return is_named;
    }
    bool is_positional = lua_geti(L, 1, 1) != LUA_TNIL;
    if (is_named && is_positional) {
        lua_error_tr(L, "%s takes one %s, not two", keyword->name, keyword->parameters->name);
    }
    lua_pushvalue(L, is_positional ? -1 : -2);
    return is_named || is_positional;
}

void read_check_arguments(lua_State *L, const Keyword *const *keywords, const Keyword *nested) {
    const char *name = keywords[0]->name;
    if (lua_gettop(L) != 1 || !lua_istable(L, 1)) {
        lua_error_tr(L, "%s takes its fields in braces: %s { ... }", name, name);
    }
    read_check_table(L, 1, keywords, nested);
}

void read_check_table(lua_State *L, int index, const Keyword *const *keywords,
                      const Keyword *nested) {
    const char *name = keywords[0]->name;
    // Lua's order of keys is another in each run; of several errors, the first by name is told.
    bool has_nameless = false, has_nameless_number = false, has_named_number = false;
    Suggestion unknown = {0};
    lua_pushnil(L);
    while (lua_next(L, index)) {
        bool is_number = lua_type(L, -1) == LUA_TNUMBER;
        lua_pop(L, 1);
        bool is_named = lua_type(L, -1) == LUA_TSTRING;
        Suggestion suggestion = {.word = is_named ? lua_tostring(L, -1) : NULL};
        has_named_number = has_named_number || (is_named && is_number);
        if (!is_named) {
            has_nameless = has_nameless || !is_positional_key(L, keywords[0]);
            has_nameless_number = has_nameless_number || (is_number && lua_isinteger(L, -1));
        } else if (!has_field(keywords, nested, &suggestion) &&
                   (!unknown.word || strcmp(suggestion.word, unknown.word) < 0)) {
            unknown = suggestion;
        }
    }
    if (has_nameless) {
        lua_error_tr(L, "%s takes fields with names, such as `%s = ...`; one has none%s", name,
                     keywords[0]->parameters->name,
                     // What a decimal comma leaves of a field: radius = 1, and 5.
                     has_named_number && has_nameless_number ? decimal_point_hint() : "");
    }
    if (unknown.word) {
        raise_unknown_field(L, name, nested, &unknown);
    }
}

void *read_fields(lua_State *L, const Keyword *keyword, uint64_t *given_mask) {
    char *values = lua_newuserdatauv(L, keyword->size, 0);
    const int top = lua_gettop(L);
    Error error = {0};
    memcpy(values, keyword->defaults, keyword->size);
    *given_mask = 0;
    for (int i = 0; keyword->parameters[i].name; i++) {
        const Parameter *row = &keyword->parameters[i];
        if (push_field(L, keyword, i)) {
            read_value(L, lua_gettop(L), row, values + row->offset);
            *given_mask |= (uint64_t)1 << i;
        }
        lua_settop(L, top);
    }
    if (keyword->finish && !keyword->finish(values, *given_mask, &error)) {
        lua_error_tr(L, "%s", error.message);
    }
    return values;
}
