/**
 * @file
 * @brief The words of scenes and lessons for the page's editor: from the same tables that the
 * parser reads.
 */
#include "base/json.h"
#include "dioptre/scene.h"
#include "dioptre/scene_override.h"
#include "dioptre/view.h"
#include "script/include.h"
#include "script/lesson_functions.h"
#include "script/library.h"
#include "script/sdf_binding.h"

#include <emscripten.h>
#include <lauxlib.h>
#include <libintl.h>
#include <stdio.h>

/** Writes the fields of a keyword. */
static void write_fields(JsonWriter *json, const Parameter *row) {
    for (; row->name; row++) {
        json_object_begin(json, NULL);
        json_string(json, "name", row->name);
        json_string(json, "help", row->help ? gettext(row->help) : "");
        json_string(json, "unit", row->unit ? gettext(row->unit) : "");
        json_array_begin(json, "choices");
        for (const char *const *choice = row->choices; choice && *choice; choice++) {
            json_string(json, NULL, *choice);
        }
        json_array_end(json);
        json_object_end(json);
    }
}

/** Writes a keyword. @param is_shape Whether it takes the fields of all shapes, too. */
static void write_keyword(JsonWriter *json, const Keyword *keyword, bool is_shape) {
    json_object_begin(json, NULL);
    json_string(json, "name", keyword->name);
    json_string(json, "help", keyword->help ? gettext(keyword->help) : "");
    json_bool(json, "is_shape", is_shape);
    json_array_begin(json, "fields");
    write_fields(json, keyword->parameters);
    if (is_shape) {
        write_fields(json, transform_keyword.parameters);
    }
    json_array_end(json);
    json_object_end(json);
}

/** Writes the keywords with their fields. */
static void write_keywords(JsonWriter *json) {
    static const Keyword *const single[] = {&scene_camera_keyword, &scene_image_keyword,
                                            &scene_sky_keyword};
    json_array_begin(json, "keywords");
    for (size_t i = 0; i < sizeof single / sizeof *single; i++) {
        write_keyword(json, single[i], false);
    }
    for (int i = 0; scene_object_keyword(i); i++) {
        write_keyword(json, scene_object_keyword(i), scene_object_is_shape(i));
    }
    json_array_end(json);
}

/**
 * Writes the names in a table that lead to no table.
 * @param L       The state, with the table on top.
 * @param prefix  What is written before a name.
 */
static void write_names(lua_State *L, const char *prefix, JsonWriter *json) {
    char name[64];
    lua_pushnil(L);
    while (lua_next(L, -2)) {
        if (lua_type(L, -2) == LUA_TSTRING && !lua_istable(L, -1)) {
            snprintf(name, sizeof name, "%s%s", prefix, lua_tostring(L, -2));
            json_string(json, NULL, name);
        }
        lua_pop(L, 1);
    }
}

/** Writes the functions and constants of Lua that a scene may use, such as `math.sin`. */
static void write_functions(JsonWriter *json) {
    static const char *const tables[] = {"math", "string", "table", "utf8", "distance"};
    lua_State *L = luaL_newstate();
    json_array_begin(json, "functions");
    if (L) {
        library_open(L);
        sdf_binding_open(L);
        include_open(L);
        lua_pushglobaltable(L);
        write_names(L, "", json);
        for (size_t i = 0; i < sizeof tables / sizeof *tables; i++) {
            char prefix[16];
            snprintf(prefix, sizeof prefix, "%s.", tables[i]);
            lua_getfield(L, -1, tables[i]);
            write_names(L, prefix, json);
            lua_pop(L, 1);
        }
        lua_close(L);
    }
    json_array_end(json);
}

/** Writes the functions that a lesson has besides those of Lua, such as `caption`. */
static void write_lesson_functions(JsonWriter *json) {
    lua_State *L = luaL_newstate();
    json_array_begin(json, "lesson_functions");
    if (L) {
        lesson_dialect.open(L);
        lua_pushglobaltable(L);
        write_names(L, "", json);
        lua_close(L);
    }
    json_array_end(json);
}

/** Writes the names of what a lesson presses and holds, such as `camera right`. */
static void write_actions(JsonWriter *json) {
    const char *names[VIEW_ACTIONS_MAXIMUM];
    view_actions(names);
    json_array_begin(json, "actions");
    for (size_t i = 0; names[i]; i++) {
        json_string(json, NULL, names[i]);
    }
    json_array_end(json);
}

/** @return All keywords with their fields, the functions, and what lessons have, as JSON, in the
 * language of the window; NULL without memory. To be freed by the caller. Called by the page. */
EMSCRIPTEN_KEEPALIVE char *web_words(void) {
    char *text = NULL;
    size_t size = 0;
    JsonWriter json = {.stream = open_memstream(&text, &size)};
    if (!json.stream) {
        return NULL;
    }
    json_object_begin(&json, NULL);
    write_keywords(&json);
    write_functions(&json);
    write_lesson_functions(&json);
    write_actions(&json);
    json_object_end(&json);
    fclose(json.stream);
    return text;
}
