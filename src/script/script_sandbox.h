/**
 * @file
 * @brief A Lua state that can do nothing but compute, within a limit of memory, and of which it is
 *        known at any time which line it is at.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_SANDBOX_H
#define DIOPTRE_SCRIPT_SCRIPT_SANDBOX_H

#include "assets/process/worker_main.h"
#include "script/script_result.h"
#include "script/script_text.h"

#include <lua.h>

/** Limits of a Lua state, and what it has used of them. The rest of the room finds it by L. */
typedef struct ScriptSandbox {
    lua_State *lua;       /**< The state; NULL while it is being made. */
    ScriptResult *result; /**< Report of the run: where the state is. */
    WorkerJob *job;       /**< Sends the report. */
    void *context;        /**< What the keywords work on. */
    size_t memory_limit;  /**< Bytes that it may use. */
    size_t memory_used;   /**< Bytes that it uses. */
    size_t bytes_printed; /**< Bytes that it has printed. */
    SourceLocation
        out_of_memory_at; /**< Where it was when it wanted more memory than it may use. */
} ScriptSandbox;

/**
 * Makes the Lua state of a sandbox, without any library.
 * @param[in,out] sandbox  Its memory, report and context are set, the rest is zero. Must stay where
 *                         it is, and so must the state: it ends with the process.
 * @return false if the memory does not even suffice for that.
 */
bool script_sandbox_init(ScriptSandbox *sandbox);

/** @return The sandbox that a Lua state belongs to. */
ScriptSandbox *script_sandbox_of(lua_State *L);

/** Begins to keep #ScriptResult.location up to date. */
void script_sandbox_track_location(lua_State *L);

/** @return Where a Lua state is: in its innermost Lua function. #SOURCE_LOCATION_START if it is in
 *  none. Takes no memory, and so can be asked at any time. */
SourceLocation script_sandbox_location(lua_State *L);

/**
 * Compiles a text and puts it on the stack as a function; raises what is wrong with it. No compiled
 * Lua is taken.
 * @param script  The text; released in any case.
 * @param path  The file, as the user knows it.
 */
void script_sandbox_load(lua_State *L, ScriptText *script, const char *path);

/** Says that a sandbox has run out of memory. */
void script_sandbox_memory_message(const ScriptSandbox *sandbox, char *message, size_t size);

#endif
