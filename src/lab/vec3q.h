/**
 * @file
 * @brief Vectors in quad precision: the reference of all methods.
 */
#ifndef DIOPTRE_LAB_VEC3Q_H
#define DIOPTRE_LAB_VEC3Q_H

#include "dioptre/engine.h"

/** A point or a direction in quad precision. */
typedef struct Vec3q {
    Quadruple x; /**< To the right. */
    Quadruple y; /**< Up. */
    Quadruple z; /**< Towards the viewer. */
} Vec3q;

/** @return a + b. */
static inline Vec3q vec3q_add(Vec3q a, Vec3q b) {
    return (Vec3q){a.x + b.x, a.y + b.y, a.z + b.z};
}

/** @return a - b. */
static inline Vec3q vec3q_subtract(Vec3q a, Vec3q b) {
    return (Vec3q){a.x - b.x, a.y - b.y, a.z - b.z};
}

/** @return v s. */
static inline Vec3q vec3q_scale(Vec3q v, Quadruple s) {
    return (Vec3q){v.x * s, v.y * s, v.z * s};
}

/** @return a . b. */
static inline Quadruple vec3q_dot(Vec3q a, Vec3q b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return a x b. */
static inline Vec3q vec3q_cross(Vec3q a, Vec3q b) {
    return (Vec3q){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** @return The square root. @param x At least 0, or NaN comes back. */
Quadruple quad_sqrt(Quadruple x);

/** @return The angle of a point, -pi to pi. */
Quadruple quad_atan2(Quadruple y, Quadruple x);

/** @return The absolute value. */
static inline Quadruple quad_abs(Quadruple x) {
    return x < 0 ? -x : x;
}

/** @return Whether it is a number. */
static inline bool quad_is_number(Quadruple x) {
    return x == x;
}

/** @return The length. */
static inline Quadruple vec3q_length(Vec3q v) {
    return quad_sqrt(vec3q_dot(v, v));
}

/** @return The same direction, of length 1. */
static inline Vec3q vec3q_normalize(Vec3q v) {
    return vec3q_scale(v, 1 / vec3q_length(v));
}

/** A distance of no hit. */
#define QUAD_NO_HIT ((Quadruple)__builtin_inf())

#endif
