/**
 * @file
 * @brief Distance fields that a scene gives as a function.
 *
 * The function is called once with symbols for x, y and z. Arithmetic and `math` on symbols record
 * a tape (dioptre/sdf_tape.h); anything that a tape cannot do raises an error at its line.
 */
#ifndef DIOPTRE_SCRIPT_SDF_FUNCTION_H
#define DIOPTRE_SCRIPT_SDF_FUNCTION_H

#include "dioptre/sdf_tape.h"

#include <lua.h>

/** Lets `math` take symbols, and creates their metatable. @param L The state. */
void sdf_function_open(lua_State *L);

/**
 * Records a function; raises an error if it cannot be a tape. Adds a note to the scene where it is
 * no distance.
 * @param L      The state.
 * @param index  Stack index of the function.
 * @return The field; it lies on top of the stack, a userdata without metatable.
 */
Sdf *sdf_function_push(lua_State *L, int index);

#endif
