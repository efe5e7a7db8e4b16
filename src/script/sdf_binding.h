/**
 * @file
 * @brief Distance fields in scene files: the table `distance`, and what fields can do.
 */
#ifndef DIOPTRE_SCRIPT_SDF_BINDING_H
#define DIOPTRE_SCRIPT_SDF_BINDING_H

#include "dioptre/sdf.h"

#include <lua.h>

/** Makes `distance` a global word of a state. */
void sdf_binding_open(lua_State *L);

/**
 * @return A field; NULL if it is something else.
 * @param index  Where it is; it is valid while it is there.
 */
const Sdf *sdf_binding_test(lua_State *L, int index);

#endif
