/**
 * @file
 * @brief Keywords of the scene language that add to a scene.
 */
#ifndef SCRIPT_KEYWORDS_H
#define SCRIPT_KEYWORDS_H

#include <lua.h>

/**
 * Adds the keywords as global functions: those of every scene, and those of the shapes in
 * #ScriptRun.
 * @param L  The state.
 */
void keywords_open(lua_State *L);

#endif
