/**
 * @file
 * @brief A Lua state with limits.
 */
#include "script/script_sandbox.h"

#include "script/lua_error.h"

#include <assert.h>
#include <lauxlib.h>
#include <libintl.h>
#include <stdio.h>

static_assert(CHUNK_NAME_SIZE <= LUA_IDSIZE, "Lua must not cut the names of files");
static_assert(LUA_EXTRASPACE >= sizeof(ScriptSandbox *), "the sandbox is found by its state");

/**
 * Allocates, resizes or frees memory of a Lua state, up to its limit. See lua_Alloc.
 * @param context   The #ScriptSandbox.
 * @param block     The memory to resize, or NULL.
 * @param old_size  Its size in bytes; no size if it is NULL.
 * @param new_size  New size in bytes; 0 frees it.
 * @return The memory; NULL if there is none, which Lua reports as an error.
 */
static void *allocate(void *context, void *block, size_t old_size, size_t new_size) {
    ScriptSandbox *sandbox = context;
    size_t old = block ? old_size : 0;
    if (new_size == 0) {
        worker_job_resize(block, 0);
        sandbox->memory_used -= old;
        return NULL;
    }
    bool is_over_limit =
        new_size > old && new_size - old > sandbox->memory_limit - sandbox->memory_used;
    void *memory = is_over_limit ? NULL : worker_job_resize(block, new_size);
    if (memory) {
        sandbox->memory_used = sandbox->memory_used - old + new_size;
    } else if (sandbox->lua) {
        sandbox->out_of_memory_at = script_sandbox_location(sandbox->lua);
    }
    return memory;
}

bool script_sandbox_init(ScriptSandbox *sandbox) {
    sandbox->out_of_memory_at = SOURCE_LOCATION_START;
    lua_State *L = lua_newstate(allocate, sandbox);
    if (L) {
        *(ScriptSandbox **)lua_getextraspace(L) = sandbox;
        sandbox->lua = L;
    }
    return L != NULL;
}

ScriptSandbox *script_sandbox_of(lua_State *L) {
    return *(ScriptSandbox **)lua_getextraspace(L);
}

SourceLocation script_sandbox_location(lua_State *L) {
    const ScriptResult *result = script_sandbox_of(L)->result;
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame); level++) {
        lua_getinfo(L, "Sl", &frame);
        int file = frame.currentline > 0 ? script_result_find_file(result, frame.short_src) : -1;
        if (file >= 0) {
            return (SourceLocation){file, frame.currentline};
        }
    }
    return SOURCE_LOCATION_START;
}

/** Records the current line, and ends a run whose time has passed. See lua_Hook. @param L The
 * state. @param event Unused. */
static void location_hook(lua_State *L, lua_Debug *event) {
    (void)event;
    script_sandbox_of(L)->result->location = script_sandbox_location(L);
    worker_job_check();
}

void script_sandbox_track_location(lua_State *L) {
    /** Number of instructions between two calls: some microseconds. */
    const int interval = 1000;
    // The count detects loops in Lua, and the call event detects long library functions.
    lua_sethook(L, location_hook, LUA_MASKCOUNT | LUA_MASKCALL, interval);
}

void script_sandbox_load(lua_State *L, ScriptText *script, const char *path, const char *name) {
    ScriptSandbox *sandbox = script_sandbox_of(L);
    const ScriptFile *file = script_result_add_file(sandbox->result, path, name);
    sandbox->job->report_size = script_result_size(sandbox->result);
    if (!file) {
        script_text_deinit(script);
        lua_error_tr(L, "a scene may not be made of more than %d files", SCRIPT_FILES_MAXIMUM);
        return;
    }
    size_t size;
    const char *text = script_text_body(script, &size);
    int status = luaL_loadbufferx(L, text, size, file->chunk_name, "t");
    script_text_deinit(script);
    if (status == LUA_ERRMEM) {
        char message[ERROR_MESSAGE_SIZE];
        script_sandbox_memory_message(sandbox, message, sizeof message);
        lua_error_tr(L, "%s", message);
    } else if (status != LUA_OK) {
        lua_error(L);
    }
}

void script_sandbox_memory_message(const ScriptSandbox *sandbox, char *message, size_t size) {
    const double mebibyte = 1024 * 1024;
    snprintf(message, size, gettext("the scene needs more than %g MiB of memory"),
             (double)sandbox->memory_limit / mebibyte);
}
