/**
 * @file
 * @brief The function `include` of the scene language.
 */
#include "script/include.h"

#include "script/asset_path.h"
#include "script/lua_error.h"
#include "script/script_run.h"
#include "script/script_sandbox.h"

#include <lauxlib.h>
#include <string.h>
#include <unistd.h>

static int call_include(lua_State *L);

/**
 * Reads a file to include.
 * @param request            The request, with the folder.
 * @param name               Name of the file in the scene.
 * @param[out] text          Its text, to be released with #script_text_deinit.
 * @param[out] display_path  Its path for messages.
 * @param[out] error         What is wrong.
 * @return false if it cannot be included.
 */
static bool read_file(const ScriptRequest *request, const char *name, ScriptText *text,
                      char display_path[PATH_MAX], Error *error) {
    char real_path[PATH_MAX];
    struct stat info;
    int file = asset_path_open(request, name, display_path, real_path, &info, error);
    if (file < 0) {
        return false;
    }
    bool is_read = script_text_read_open(text, file, error);
    close(file);
    if (!is_read) {
        return false;
    }
    if (!script_text_check(text, NULL, error)) {
        script_text_deinit(text);
        return false;
    }
    return true;
}

/** Compiles a file and pushes it as a function; raises an error if it cannot be included. */
static void load_file(lua_State *L, const char *name) {
    const ScriptRun *run = script_sandbox_of(L)->context;
    char display_path[PATH_MAX];
    ScriptText text;
    Error error = {0};
    if (read_file(run->request, name, &text, display_path, &error)) {
        script_sandbox_load(L, &text, display_path, name);
    } else {
        lua_error_tr(L, "cannot include `%s`: %s", name, error.message);
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
