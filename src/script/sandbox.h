/**
 * @file
 * @brief A Lua state that can do nothing but compute, within a limit of memory, and of which it is
 *        known at any time which line it is at.
 */
#ifndef SCRIPT_SANDBOX_H
#define SCRIPT_SANDBOX_H

#include "script/report.h"
#include "script/source.h"

#include <lua.h>

/** Limits of a Lua state, and what it has used of them. The rest of the room finds it by L. */
typedef struct Sandbox {
    lua_State *lua;   /**< The state; NULL while it is being made. */
    Report *report;   /**< Where the state is; shared with the parent. */
    void *context;    /**< What the keywords work on. */
    size_t memory;    /**< Bytes that it may use. */
    size_t used;      /**< Bytes that it uses. */
    size_t printed;   /**< Bytes that it has printed. */
    Location refused; /**< Where it was when it wanted more memory than it may use. */
} Sandbox;

/**
 * Makes the Lua state of a sandbox, without any library.
 * @param[in,out] sandbox  Its memory, report and context are set, the rest is zero. Must stay where
 *                         it is, and so must the state: it ends with the process.
 * @return false if the memory does not even suffice for that.
 */
bool sandbox_init(Sandbox *sandbox);

/**
 * @return The sandbox that a Lua state belongs to.
 * @param L  The state.
 */
Sandbox *sandbox_of(lua_State *L);

/** Begins to keep #Report.location up to date. @param L The state. */
void sandbox_watch(lua_State *L);

/**
 * @return Where a Lua state is: in its innermost Lua function. #REPORT_START if it is in none.
 *         Takes no memory, and so can be asked at any time.
 * @param L  The state.
 */
Location sandbox_location(lua_State *L);

/**
 * Compiles a text and puts it on the stack as a function; raises what is wrong with it. No
 * compiled Lua is taken.
 * @param L       The state.
 * @param source  The text; released in any case.
 * @param path    The file, as the user knows it.
 */
void sandbox_load(lua_State *L, Source *source, const char *path);

/**
 * Says that a sandbox has run out of memory.
 * @param sandbox     The sandbox.
 * @param[out] words  The sentence.
 * @param size        Bytes that fit.
 */
void sandbox_describe_refusal(const Sandbox *sandbox, char *words, size_t size);

#endif
