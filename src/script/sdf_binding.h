/**
 * @file
 * @brief Distance fields in scene files: the table `distance` and the methods of fields.
 */
#ifndef DIOPTRE_SCRIPT_SDF_BINDING_H
#define DIOPTRE_SCRIPT_SDF_BINDING_H

#include "dioptre/sdf.h"

#include <lua.h>

/** Adds the global table `distance`. @param L The state. */
void sdf_binding_open(lua_State *L);

/**
 * @return The field at a stack index, valid while it is there; NULL for another type.
 * @param L      The state.
 * @param index  The stack index.
 */
const Sdf *sdf_binding_test(lua_State *L, int index);

#endif
