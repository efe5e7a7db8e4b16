/**
 * @file
 * @brief Points, vectors and colours of a scene, in double precision.
 *
 * Conventions of the whole program: right-handed axes, x to the right, y up, and a camera that
 * looks along -z when nothing is said. Angles are degrees in files and radians inside. Colours
 * are linear light; only the finished picture is encoded.
 */
#ifndef DIOPTRE_VECTOR3_H
#define DIOPTRE_VECTOR3_H

#include <math.h>

/** A point (scene units) or a direction in space. */
typedef struct Vector3 {
    double x; /**< To the right. */
    double y; /**< Up. */
    double z; /**< Towards the viewer. */
} Vector3;

/** A place in a picture that a surface wears. */
typedef struct Pair {
    double u; /**< To the right. */
    double v; /**< Up. */
} Pair;

/** An amount of linear light for each of three primaries; 1 is the brightest that is shown. */
typedef struct Color {
    double red;   /**< Red, linear. */
    double green; /**< Green, linear. */
    double blue;  /**< Blue, linear. */
} Color;

/** @return a + b. @param a A vector. @param b Another. */
static inline Vector3 vector3_add(Vector3 a, Vector3 b) {
    return (Vector3){a.x + b.x, a.y + b.y, a.z + b.z};
}

/** @return a - b. @param a A vector. @param b Another. */
static inline Vector3 vector3_subtract(Vector3 a, Vector3 b) {
    return (Vector3){a.x - b.x, a.y - b.y, a.z - b.z};
}

/** @return v made s times as long. @param v A vector. @param s Any factor. */
static inline Vector3 vector3_scale(Vector3 v, double s) {
    return (Vector3){v.x * s, v.y * s, v.z * s};
}

/** @return The scalar product a . b. @param a A vector. @param b Another. */
static inline double vector3_dot(Vector3 a, Vector3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return The vector product a x b, at right angles to both. @param a A vector. @param b Another.
 */
static inline Vector3 vector3_cross(Vector3 a, Vector3 b) {
    return (Vector3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** @return The largest absolute component. @param v A vector. */
static inline double vector3_largest(Vector3 v) {
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

/** @return The smaller of each component. @param a A point. @param b Another. */
static inline Vector3 vector3_lowest(Vector3 a, Vector3 b) {
    return (Vector3){fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z)};
}

/** @return The larger of each component. @param a A point. @param b Another. */
static inline Vector3 vector3_highest(Vector3 a, Vector3 b) {
    return (Vector3){fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z)};
}

/**
 * @return v with its largest component between 1/2 and 1, by a power of two: the same direction, to
 *         the bit, but squares of it neither overflow nor vanish.
 * @param v A finite vector that is not zero.
 */
static inline Vector3 vector3_scaled(Vector3 v) {
    int exponent;
    frexp(vector3_largest(v), &exponent);
    return (Vector3){ldexp(v.x, -exponent), ldexp(v.y, -exponent), ldexp(v.z, -exponent)};
}

/**
 * @return The length of v; neither a very long nor a very short vector overflows on the way.
 * @param v Any finite vector.
 */
static inline double vector3_length(Vector3 v) {
    double largest = vector3_largest(v);
    if (!(largest > 0)) {
        return 0;
    }
    Vector3 scaled = {v.x / largest, v.y / largest, v.z / largest};
    return largest * sqrt(vector3_dot(scaled, scaled));
}

/** @return v with length 1. @param v A vector that is not zero. */
static inline Vector3 vector3_normalize(Vector3 v) {
    double length = vector3_length(v);
    return (Vector3){v.x / length, v.y / length, v.z / length};
}

#endif
