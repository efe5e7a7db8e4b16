/**
 * @file
 * @brief The word `include`: a scene made of several files.
 */
#ifndef SCRIPT_INCLUDE_H
#define SCRIPT_INCLUDE_H

#include <lua.h>

/** How deep files may include each other: deeper is a ring. */
enum { INCLUDE_DEPTH_MAXIMUM = 32 };

/** Makes `include` a global word of a state: `include "other.lua"` runs a file that lies in the
 *  folder of the scene file, or the folder asked for, or below it, and returns what that returns.
 */
void include_open(lua_State *L);

#endif
