/**
 * @file
 * @brief The function `include` of the scene language.
 */
#include "script/include.h"

#include "script/lua_error.h"
#include "script/script_question.h"
#include "script/script_run.h"
#include "script/script_sandbox.h"

#include <lauxlib.h>
#include <string.h>
#include <unistd.h>

static int call_include(lua_State *L);

/**
 * Reads a file to include.
 * @param name         Name of the file in the scene.
 * @param[out] text    Its text, to be released with #script_text_deinit.
 * @param[out] answer  What the program knows of it; what is wrong.
 * @return false if it cannot be included.
 */
static bool read_file(const char *name, ScriptText *text, ScriptAnswer *answer) {
    int file;
    if (!script_question_ask(SCRIPT_ASK_INCLUDE, name, answer, &file)) {
        return false;
    }
    bool is_read = script_text_read_open(text, file, &answer->error);
    close(file);
    if (!is_read) {
        return false;
    }
    if (!script_text_check(text, NULL, &answer->error)) {
        script_text_deinit(text);
        return false;
    }
    return true;
}

/** Compiles a file and pushes it as a function; raises an error if it cannot be included. */
static void load_file(lua_State *L, const char *name) {
    ScriptAnswer answer;
    ScriptText text;
    if (read_file(name, &text, &answer)) {
        script_sandbox_load(L, &text, answer.display_path, name);
    } else {
        lua_error_tr(L, "cannot include `%s`: %s", name, answer.error.message);
    }
}

/**
 * @return Number of active calls of `include`. It is counted on the stack, because one caught error
 *         can end several calls.
 */
static int count_depth(lua_State *L) {
    int depth = 0;
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame); level++) {
        lua_getinfo(L, "f", &frame);
        depth += lua_tocfunction(L, -1) == call_include;
        lua_pop(L, 1);
    }
    return depth;
}

/**
 * `include "FILE"`. See lua_CFunction.
 * @param L  The state, with the name of the file.
 * @return Number of values that the file returned.
 */
static int call_include(lua_State *L) {
    size_t length;
    const char *name = luaL_checklstring(L, 1, &length);
    if (length != strlen(name)) {
        return lua_error_tr(L, "cannot include a file with a zero byte in its name");
    }
    if (count_depth(L) > INCLUDE_DEPTH_MAXIMUM) {
        return lua_error_tr(L, "files include each other more than %d deep; is this a ring?",
                            INCLUDE_DEPTH_MAXIMUM);
    }
    lua_settop(L, 1);
    load_file(L, name);
    lua_call(L, 0, LUA_MULTRET);
    return lua_gettop(L) - 1;
}

void include_open(lua_State *L) {
    lua_register(L, "include", call_include);
}
