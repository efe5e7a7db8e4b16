/**
 * @file
 * @brief A Lua state without access to the system, with a memory limit and a record of its current
 * line.
 */
#ifndef DIOPTRE_SCRIPT_SCRIPT_SANDBOX_H
#define DIOPTRE_SCRIPT_SCRIPT_SANDBOX_H

#include "assets/process/worker_main.h"
#include "script/script_result.h"
#include "script/script_text.h"

#include <lua.h>

/** Limits of a Lua state and their use. #script_sandbox_of finds it by the state. */
typedef struct ScriptSandbox {
    lua_State *lua;                  /**< The state; NULL during its creation. */
    ScriptResult *result;            /**< Report of the run, with the current line. */
    WorkerJob *job;                  /**< The worker's job, which sends the report. */
    void *context;                   /**< Data of the run: a #ScriptRun. */
    size_t memory_limit;             /**< Largest memory, bytes. */
    size_t memory_used;              /**< Memory in use, bytes. */
    size_t bytes_printed;            /**< Number of bytes printed. */
    lua_Integer objects_numbered;    /**< Number of objects whose texts were asked for. */
    SourceLocation out_of_memory_at; /**< Line at which the memory limit was reached. */
} ScriptSandbox;

/**
 * Creates the Lua state of a sandbox, without libraries.
 * @param[in,out] sandbox  The sandbox with its memory limit, report and context; the rest is zero.
 *                         It must not move. The state is never freed: it ends with the process.
 * @return false if the memory limit does not suffice.
 */
bool script_sandbox_init(ScriptSandbox *sandbox);

/** @return The sandbox of a Lua state. @param L The state. */
ScriptSandbox *script_sandbox_of(lua_State *L);

/** Starts the updates of #ScriptResult.location. @param L The state. */
void script_sandbox_track_location(lua_State *L);

/**
 * @return Current line of the innermost Lua function; #SOURCE_LOCATION_START if there is none. It
 *         allocates nothing, and so may be called at any time.
 * @param L  The state.
 */
SourceLocation script_sandbox_location(lua_State *L);

/**
 * Compiles a text and pushes it as a function; raises an error if it is invalid. Compiled Lua is
 * refused.
 * @param L       The state.
 * @param script  The text; always released.
 * @param path    Path of the file, for messages.
 * @param name    Its name in the folder of the scene.
 */
void script_sandbox_load(lua_State *L, ScriptText *script, const char *path, const char *name);

/**
 * Formats the error that the memory limit is reached.
 * @param sandbox       The sandbox.
 * @param[out] message  The text.
 * @param size          Its size in bytes.
 */
void script_sandbox_memory_message(const ScriptSandbox *sandbox, char *message, size_t size);

#endif
