/**
 * @file
 * @brief A Lua state within limits.
 */
#include "script/sandbox.h"

#include "script/raise.h"

#include <assert.h>
#include <lauxlib.h>
#include <libintl.h>
#include <stdio.h>
#include <stdlib.h>

static_assert(REPORT_CHUNK_SIZE <= LUA_IDSIZE, "Lua must not cut the names of files");
static_assert(LUA_EXTRASPACE >= sizeof(Sandbox *), "the sandbox is found by its state");

/**
 * Gives a Lua state memory, up to its limit. See lua_Alloc.
 * @param context   A #Sandbox.
 * @param block     What is to change its size, or NULL.
 * @param old_size  Bytes of it; no size if it is NULL.
 * @param new_size  Bytes wanted; 0 gives it back.
 * @return The memory; NULL if there is none, which Lua raises as an error.
 */
static void *allocate(void *context, void *block, size_t old_size, size_t new_size) {
    Sandbox *sandbox = context;
    size_t old = block ? old_size : 0;
    if (new_size == 0) {
        free(block);
        sandbox->used -= old;
        return NULL;
    }
    bool is_refused = new_size > old && new_size - old > sandbox->memory - sandbox->used;
    void *given = is_refused ? NULL : realloc(block, new_size);
    if (given) {
        sandbox->used = sandbox->used - old + new_size;
    } else if (sandbox->lua) {
        sandbox->refused = sandbox_location(sandbox->lua);
    }
    return given;
}

bool sandbox_init(Sandbox *sandbox) {
    sandbox->refused = REPORT_START;
    lua_State *L = lua_newstate(allocate, sandbox);
    if (L) {
        *(Sandbox **)lua_getextraspace(L) = sandbox;
        sandbox->lua = L;
    }
    return L != NULL;
}

Sandbox *sandbox_of(lua_State *L) {
    return *(Sandbox **)lua_getextraspace(L);
}

Location sandbox_location(lua_State *L) {
    const Report *report = sandbox_of(L)->report;
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame); level++) {
        lua_getinfo(L, "Sl", &frame);
        int file = frame.currentline > 0 ? report_find_file(report, frame.short_src) : -1;
        if (file >= 0) {
            return (Location){file, frame.currentline};
        }
    }
    return REPORT_START;
}

/**
 * Notes where the state is. See lua_Hook.
 * @param L      The state.
 * @param event  Why now; not used.
 */
static void note_location(lua_State *L, lua_Debug *event) {
    (void)event;
    sandbox_of(L)->report->location = sandbox_location(L);
}

void sandbox_watch(lua_State *L) {
    /** Instructions between two looks: some microseconds. */
    const int interval = 1000;
    // A loop in Lua is noticed by the count, and one inside a library function by the call of it.
    lua_sethook(L, note_location, LUA_MASKCOUNT | LUA_MASKCALL, interval);
}

void sandbox_load(lua_State *L, Source *source, const char *path) {
    const ReportFile *file = report_add_file(sandbox_of(L)->report, path);
    if (!file) {
        source_release(source);
        raise_error(L, "a scene may not be made of more than %d files", REPORT_FILES_MAXIMUM);
        return;
    }
    size_t size;
    const char *text = source_text(source, &size);
    int status = luaL_loadbufferx(L, text, size, file->chunk, "t");
    source_release(source);
    if (status == LUA_ERRMEM) {
        char words[ERROR_MESSAGE_SIZE];
        sandbox_describe_refusal(sandbox_of(L), words, sizeof words);
        raise_error(L, "%s", words);
    } else if (status != LUA_OK) {
        lua_error(L);
    }
}

void sandbox_describe_refusal(const Sandbox *sandbox, char *words, size_t size) {
    const double mebibyte = 1024 * 1024;
    snprintf(words, size, gettext("the scene needs more than %g MiB of memory"),
             (double)sandbox->memory / mebibyte);
}
