/**
 * @file
 * @brief Vectors of an engine: LANES points or directions side by side.
 */
#ifndef DIOPTRE_TRACE_VECTOR_H
#define DIOPTRE_TRACE_VECTOR_H

#include "trace/compare.h"
#include "trace/root.h"

/** LANES points or directions. */
typedef struct Vector {
    real x; /**< To the right. */
    real y; /**< Up. */
    real z; /**< Towards the viewer. */
} Vector;

/** LANES points or directions in the next better precision. */
typedef struct WideVector {
    wide x; /**< To the right. */
    wide y; /**< Up. */
    wide z; /**< Towards the viewer. */
} WideVector;

/** One point or direction, in the next better precision: how shapes keep theirs. */
typedef struct WidePoint {
    wide_scalar x; /**< To the right. */
    wide_scalar y; /**< Up. */
    wide_scalar z; /**< Towards the viewer. */
} WidePoint;

/** One point or direction in the engine's numbers. */
typedef struct Point {
    scalar x; /**< To the right. */
    scalar y; /**< Up. */
    scalar z; /**< Towards the viewer. */
} Point;

/** LANES amounts of linear light. */
typedef struct Light3 {
    real red;   /**< Red. */
    real green; /**< Green. */
    real blue;  /**< Blue. */
} Light3;

/** One amount of linear light, or a share of it. */
typedef struct Scalar3 {
    scalar red;   /**< Red. */
    scalar green; /**< Green. */
    scalar blue;  /**< Blue. */
} Scalar3;

/* --- making them ------------------------------------------------------------------------------ */

/** @return The same point in all lanes. @param v A point of the scene. */
INLINE Vector vector_of(Vector3 v) {
    return (Vector){real_of((scalar)v.x), real_of((scalar)v.y), real_of((scalar)v.z)};
}

/** @return A point, exactly. @param v A point of the scene. */
INLINE WidePoint wide_point_of(Vector3 v) {
    return (WidePoint){(wide_scalar)v.x, (wide_scalar)v.y, (wide_scalar)v.z};
}

/** @return A point of the scene, rounded. @param p A better one. */
INLINE Vector3 vector3_of(WidePoint p) {
    return (Vector3){(double)p.x, (double)p.y, (double)p.z};
}

/** @return The same point in all lanes. @param p A point. */
INLINE WideVector wide_vector_of(WidePoint p) {
    return (WideVector){wide_of(p.x), wide_of(p.y), wide_of(p.z)};
}

/** @return A point, rounded. @param p A better one. */
INLINE Point point_narrow(WidePoint p) {
    return (Point){(scalar)p.x, (scalar)p.y, (scalar)p.z};
}

/** @return The same point in all lanes. @param p A point. */
INLINE Vector vector_of_point(Point p) {
    return (Vector){real_of(p.x), real_of(p.y), real_of(p.z)};
}

/** @return The same numbers, exactly. @param v Vectors. */
INLINE WideVector vector_widen(Vector v) {
    return (WideVector){widen(v.x), widen(v.y), widen(v.z)};
}

/** @return The nearest numbers of the engine's type. @param v Better vectors. */
INLINE Vector vector_narrow(WideVector v) {
    return (Vector){narrow(v.x), narrow(v.y), narrow(v.z)};
}

/* --- arithmetic ------------------------------------------------------------------------------- */

/** @return a + b. @param a Vectors. @param b Others. */
INLINE Vector vector_add(Vector a, Vector b) {
    return (Vector){a.x + b.x, a.y + b.y, a.z + b.z};
}

/** @return a - b. @param a Vectors. @param b Others. */
INLINE Vector vector_subtract(Vector a, Vector b) {
    return (Vector){a.x - b.x, a.y - b.y, a.z - b.z};
}

/** @return v made s times as long. @param v Vectors. @param s Factors. */
INLINE Vector vector_scale(Vector v, real s) {
    return (Vector){v.x * s, v.y * s, v.z * s};
}

/** @return a . b, added up in the order x, y, z. @param a Vectors. @param b Others. */
INLINE real vector_dot(Vector a, Vector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return v with length 1. @param v Vectors that are not zero. */
INLINE Vector vector_normalize(Vector v) {
    return vector_scale(v, 1 / real_sqrt(vector_dot(v, v)));
}

/** @return The largest absolute component. @param v Vectors. */
INLINE real vector_largest(Vector v) {
    return real_max(real_abs(v.x), real_max(real_abs(v.y), real_abs(v.z)));
}

/** @return a where the mask is set, b elsewhere. @param m A mask. @param a Vectors. @param b
 * Others. */
INLINE Vector vector_select(mask m, Vector a, Vector b) {
    return (Vector){real_select(m, a.x, b.x), real_select(m, a.y, b.y), real_select(m, a.z, b.z)};
}

/** @return a - b. @param a Better vectors. @param b Others. */
INLINE WideVector wide_subtract(WideVector a, WideVector b) {
    return (WideVector){a.x - b.x, a.y - b.y, a.z - b.z};
}

/** @return v made s times as long. @param v Better vectors. @param s Factors. */
INLINE WideVector wide_scale(WideVector v, wide s) {
    return (WideVector){v.x * s, v.y * s, v.z * s};
}

/** @return a where the mask is set, b elsewhere. @param m A mask. @param a Better vectors.
 *  @param b Others. */
INLINE WideVector wide_vector_select(wide_mask m, WideVector a, WideVector b) {
    return (WideVector){wide_select(m, a.x, b.x), wide_select(m, a.y, b.y),
                        wide_select(m, a.z, b.z)};
}

/** @return a + s * v. @param a Better vectors. @param v Others. @param s Factors. */
INLINE WideVector wide_add_scaled(WideVector a, WideVector v, wide s) {
    return (WideVector){a.x + v.x * s, a.y + v.y * s, a.z + v.z * s};
}

/** @return a . b, added up in the order x, y, z. @param a Better vectors. @param b Others. */
INLINE wide wide_dot(WideVector a, WideVector b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return a x b. @param a Better vectors. @param b Others. */
INLINE WideVector wide_cross(WideVector a, WideVector b) {
    return (WideVector){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** @return a - b, one of each. @param a A point. @param b Another. */
static inline WidePoint wide_point_subtract(WidePoint a, WidePoint b) {
    return (WidePoint){a.x - b.x, a.y - b.y, a.z - b.z};
}

/** @return v made s times as long. @param v A direction. @param s Any factor. */
static inline WidePoint wide_point_scale(WidePoint v, wide_scalar s) {
    return (WidePoint){v.x * s, v.y * s, v.z * s};
}

/** @return a . b, one of each. @param a A direction. @param b Another. */
static inline wide_scalar wide_point_dot(WidePoint a, WidePoint b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return a x b, one of each. @param a A direction. @param b Another. */
static inline WidePoint wide_point_cross(WidePoint a, WidePoint b) {
    return (WidePoint){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** @return v with length 1. @param v A direction, not zero. */
static inline WidePoint wide_point_normalize(WidePoint v) {
    wide_scalar length = (wide_scalar)WIDE_SQRT(v.x * v.x + v.y * v.y + v.z * v.z);
    return (WidePoint){v.x / length, v.y / length, v.z / length};
}

/* --- light ------------------------------------------------------------------------------------ */

/** @return A colour in the engine's number type. @param c A colour of the scene. */
INLINE Scalar3 scalar3_of(Color c) {
    return (Scalar3){(scalar)c.red, (scalar)c.green, (scalar)c.blue};
}

/** @return The same light in all lanes. @param c One amount. */
INLINE Light3 light3_of(Scalar3 c) {
    return (Light3){real_of(c.red), real_of(c.green), real_of(c.blue)};
}

/** @return a + b. @param a Light. @param b More. */
INLINE Light3 light3_add(Light3 a, Light3 b) {
    return (Light3){a.red + b.red, a.green + b.green, a.blue + b.blue};
}

/** @return a times b, primary by primary. @param a Light. @param b Shares. */
INLINE Light3 light3_multiply(Light3 a, Light3 b) {
    return (Light3){a.red * b.red, a.green * b.green, a.blue * b.blue};
}

/** @return a times s. @param a Light. @param s Factors. */
INLINE Light3 light3_scale(Light3 a, real s) {
    return (Light3){a.red * s, a.green * s, a.blue * s};
}

/** @return The strongest primary. @param a Light. */
INLINE real light3_largest(Light3 a) {
    return real_max(a.red, real_max(a.green, a.blue));
}

/** @return a where the mask is set, b elsewhere. @param m A mask. @param a Light. @param b Other.
 */
INLINE Light3 light3_select(mask m, Light3 a, Light3 b) {
    return (Light3){real_select(m, a.red, b.red), real_select(m, a.green, b.green),
                    real_select(m, a.blue, b.blue)};
}

#endif
