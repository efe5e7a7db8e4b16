/**
 * @file
 * @brief The function `include`: a scene of several files.
 */
#ifndef SCRIPT_INCLUDE_H
#define SCRIPT_INCLUDE_H

#include <lua.h>

/** Largest depth of nested includes; it stops files that include each other. */
enum { INCLUDE_DEPTH_MAXIMUM = 32 };

/**
 * Adds the global function `include`: `include "other.lua"` runs a file in the folder of the scene
 * (#ScriptRequest.base_dir) or below it, and returns what the file returns.
 * @param L  The state.
 */
void include_open(lua_State *L);

#endif
