/**
 * @file
 * @brief The words of the scene language that add to a scene.
 */
#ifndef SCRIPT_KEYWORDS_H
#define SCRIPT_KEYWORDS_H

#include <lua.h>

/** Makes the keywords global words of a state: those of every scene, and those of the shapes that
 *  its #ScriptRun can name. */
void keywords_open(lua_State *L);

#endif
