/**
 * @file
 * @brief Points and directions in quad precision: what the methods are held against.
 */
#ifndef DIOPTRE_LAB_QUAD_H
#define DIOPTRE_LAB_QUAD_H

#include "dioptre/engine.h"

/** A point or a direction in quad precision. */
typedef struct Quad3 {
    Quadruple x; /**< To the right. */
    Quadruple y; /**< Up. */
    Quadruple z; /**< Towards the viewer. */
} Quad3;

/** @return a + b. @param a A vector. @param b Another. */
static inline Quad3 quad3_add(Quad3 a, Quad3 b) {
    return (Quad3){a.x + b.x, a.y + b.y, a.z + b.z};
}

/** @return a - b. @param a A vector. @param b Another. */
static inline Quad3 quad3_subtract(Quad3 a, Quad3 b) {
    return (Quad3){a.x - b.x, a.y - b.y, a.z - b.z};
}

/** @return v made s times as long. @param v A vector. @param s A factor. */
static inline Quad3 quad3_scale(Quad3 v, Quadruple s) {
    return (Quad3){v.x * s, v.y * s, v.z * s};
}

/** @return a . b. @param a A vector. @param b Another. */
static inline Quadruple quad3_dot(Quad3 a, Quad3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return a x b. @param a A vector. @param b Another. */
static inline Quad3 quad3_cross(Quad3 a, Quad3 b) {
    return (Quad3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** @return The square root. @param x At least 0, or NaN comes back. */
Quadruple quad_sqrt(Quadruple x);

/** @return The angle of a point, -pi to pi. @param y Its ordinate. @param x Its abscissa. */
Quadruple quad_atan2(Quadruple y, Quadruple x);

/** @return The absolute value. @param x Any number. */
static inline Quadruple quad_abs(Quadruple x) {
    return x < 0 ? -x : x;
}

/** @return Whether it is a number. @param x Any, or NaN. */
static inline bool quad_is_number(Quadruple x) {
    return x == x;
}

/** @return The length. @param v A vector. */
static inline Quadruple quad3_length(Quad3 v) {
    return quad_sqrt(quad3_dot(v, v));
}

/** @return The same direction, of length 1. @param v Not zero. */
static inline Quad3 quad3_normalize(Quad3 v) {
    return quad3_scale(v, 1 / quad3_length(v));
}

/** What stands for no distance at all in answers. */
#define QUAD_NONE ((Quadruple)__builtin_inf())

#endif
