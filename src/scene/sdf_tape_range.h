/**
 * @file
 * @brief Interval arithmetic for the steps of tapes.
 */
#ifndef DIOPTRE_SCENE_SDF_TAPE_RANGE_H
#define DIOPTRE_SCENE_SDF_TAPE_RANGE_H

#include "dioptre/sdf_tape.h"

/**
 * @return Bounds of the result of a step, but for roundings. For ranges of one number it is one
 *         number: the step in double.
 * @param op        Operation; not #SDF_TAPE_INPUT.
 * @param a         Range of its first operand.
 * @param b         Range of its second operand.
 * @param constant  Its constant.
 */
SdfRange sdf_tape_step_range(SdfTapeOp op, SdfRange a, SdfRange b, double constant);

#endif
