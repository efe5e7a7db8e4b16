/**
 * @file
 * @brief Execution of scene and lesson files.
 */
#include "script/script_run.h"

#include "base/base_name.h"
#include "script/include.h"
#include "script/keywords.h"
#include "script/library.h"
#include "script/lua_error.h"
#include "script/script_sandbox.h"
#include "script/sdf_binding.h"

#include <lauxlib.h>
#include <libintl.h>
#include <locale.h>
#include <stdio.h>
#include <string.h>

/** Adds the keywords of scenes. See #ScriptDialect.open. */
static void open_scene(lua_State *L) {
    keywords_open(L);
    sdf_binding_open(L);
    include_open(L);
}

/** Raises an error if the scene has no camera. See #ScriptDialect.check. */
static void check_scene(lua_State *L) {
    if (!((ScriptRun *)script_sandbox_of(L)->context)->scene->has_camera) {
        lua_error_tr(L, "there is no camera in the scene; "
                        "try camera { position = {0, 0, 5}, look_at = {0, 0, 0} }");
    }
}

const ScriptDialect scene_dialect = {.open = open_scene, .check = check_scene};

/** Opens the libraries and runs the text; errors are raised. See lua_CFunction. @return 0 */
static int run_protected(lua_State *L) {
    ScriptRun *run = script_sandbox_of(L)->context;
    library_open(L);
    run->dialect->open(L);
    script_sandbox_track_location(L);
    ScriptText text = *run->text;
    script_sandbox_load(L, &text, run->request->path, base_name(run->request->path));
    lua_call(L, 0, 0);
    library_check_metatables(L);
    run->dialect->check(L);
    return 0;
}

/**
 * Writes an uncaught error into the report. It allocates no Lua memory, because the error may be a
 * lack of memory. See lua_pcall.
 * @param L  The state, with the error on top.
 * @return 1: the error.
 */
static int handle_error(lua_State *L) {
    ScriptResult *result = script_sandbox_of(L)->result;
    char description[ERROR_MESSAGE_SIZE];
    size_t length;
    const char *text = description;
    if (lua_type(L, 1) == LUA_TSTRING) {
        text = lua_tolstring(L, 1, &length);
    } else {
        length = (size_t)snprintf(description, sizeof description,
                                  gettext("error was called with a %s, not with words"),
                                  luaL_typename(L, 1));
    }
    SourceLocation location = script_sandbox_location(L);
    size_t start = script_result_parse_location(result, text, &location);
    script_result_fail(result, location, text + start, length - start);
    return 1;
}

/**
 * Completes the report of a run.
 * @param sandbox  The sandbox of the run.
 * @param status   Result of lua_pcall.
 */
static void finish_result(const ScriptSandbox *sandbox, int status) {
    ScriptResult *result = sandbox->result;
    char message[ERROR_MESSAGE_SIZE];
    if (status == LUA_ERRMEM) {
        script_sandbox_memory_message(sandbox, message, sizeof message);
        script_result_fail(result, sandbox->out_of_memory_at, message, strlen(message));
    } else if (status != LUA_OK && result->error.status == STATUS_OK) {
        const char *message_overflow = gettext("too many errors at once");
        script_result_fail(result, result->location, message_overflow, strlen(message_overflow));
    }
}

void script_run_use_c_locale(void) {
    static const int categories[] = {LC_COLLATE, LC_CTYPE, LC_MONETARY, LC_NUMERIC, LC_TIME};
    for (size_t i = 0; i < sizeof categories / sizeof *categories; i++) {
        setlocale(categories[i], "C");
    }
}

void script_run_execute(ScriptRun *run) {
    ScriptSandbox sandbox = {.result = run->result,
                             .job = run->job,
                             .context = run,
                             .memory_limit = run->request->memory_limit};
    int status = LUA_ERRMEM;
    script_run_use_c_locale();
    if (script_sandbox_init(&sandbox)) {
        lua_State *L = sandbox.lua;
        lua_pushcfunction(L, handle_error);
        lua_pushcfunction(L, run_protected);
        status = lua_pcall(L, 0, 0, 1);
    }
    finish_result(&sandbox, status);
}
