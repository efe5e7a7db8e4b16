/**
 * @file
 * @brief What experiments pose their cases with.
 */
#ifndef DIOPTRE_LAB_EXPERIMENTS_POSE_H
#define DIOPTRE_LAB_EXPERIMENTS_POSE_H

#include "lab/experiment.h"

/** Numbers one after the other, as a method's question wants them. */
typedef struct Writer {
    const NumberType *type; /**< What they are rounded to. */
    Quadruple *next;        /**< Where the next goes. */
} Writer;

/** @return The nearest point of a number type. @param type The type. @param v A point. */
Quad3 rounded(const NumberType *type, Quad3 v);

/** @return The vector that was written: rounded. @param[in,out] writer Where to. @param v It. */
Quad3 write_vector(Writer *writer, Quad3 v);

/** @return The number that was written: rounded. @param[in,out] writer Where to. @param x It. */
Quadruple write_number(Writer *writer, Quadruple x);

/** @return A place that is so far from the origin of the world, in no special direction, and that
 *          float can hold. @param far How far. */
Quad3 place_far(double far);

/** Numbers for a scene: three of a vector. @param v It. @param[out] numbers Its coordinates. */
void to_numbers(Quad3 v, double numbers[3]);

#endif
