/**
 * @file
 * @brief Distance fields in scene files: the table `distance`, and what fields can do.
 */
#ifndef SCRIPT_FIELDS_H
#define SCRIPT_FIELDS_H

#include "dioptre/field.h"

#include <lua.h>

/** Makes `distance` a global word of a state. @param L The state. */
void fields_open(lua_State *L);

/**
 * @return A field; NULL if it is something else.
 * @param L      The state.
 * @param index  Where it is; it is valid while it is there.
 */
const Field *fields_test(lua_State *L, int index);

#endif
