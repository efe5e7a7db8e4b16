/**
 * @file
 * @brief Points, vectors and colours of a scene, in double precision.
 *
 * Conventions of the whole program: right-handed axes, x to the right, y up, and a camera that
 * looks along -z when nothing is said. Angles are degrees in files and radians inside. Colours
 * are linear light; only the finished picture is encoded.
 */
#ifndef DIOPTRE_BASE_VEC3D_H
#define DIOPTRE_BASE_VEC3D_H

#include <math.h>
#include <stdbool.h>

/** A point (scene units) or a direction in space. */
typedef struct Vec3d {
    double x; /**< To the right. */
    double y; /**< Up. */
    double z; /**< Towards the viewer. */
} Vec3d;

/** A place in a picture that a surface wears. */
typedef struct Uvd {
    double u; /**< To the right. */
    double v; /**< Up. */
} Uvd;

/** An amount of linear light for each of three primaries; 1 is the brightest that is shown. */
typedef struct Rgbd {
    double red;   /**< Red, linear. */
    double green; /**< Green, linear. */
    double blue;  /**< Blue, linear. */
} Rgbd;

/** @return a + b. @param a A vector. @param b Another. */
static inline Vec3d vec3d_add(Vec3d a, Vec3d b) {
    return (Vec3d){a.x + b.x, a.y + b.y, a.z + b.z};
}

/** @return a - b. @param a A vector. @param b Another. */
static inline Vec3d vec3d_subtract(Vec3d a, Vec3d b) {
    return (Vec3d){a.x - b.x, a.y - b.y, a.z - b.z};
}

/** @return v made s times as long. @param v A vector. @param s Any factor. */
static inline Vec3d vec3d_scale(Vec3d v, double s) {
    return (Vec3d){v.x * s, v.y * s, v.z * s};
}

/** @return The scalar product a . b. @param a A vector. @param b Another. */
static inline double vec3d_dot(Vec3d a, Vec3d b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return The vector product a x b, at right angles to both. @param a A vector. @param b Another.
 */
static inline Vec3d vec3d_cross(Vec3d a, Vec3d b) {
    return (Vec3d){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** @return The largest absolute component. @param v A vector. */
static inline double vec3d_max_abs(Vec3d v) {
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

/** @return The smaller of each component. @param a A point. @param b Another. */
static inline Vec3d vec3d_min(Vec3d a, Vec3d b) {
    return (Vec3d){fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z)};
}

/** @return The larger of each component. @param a A point. @param b Another. */
static inline Vec3d vec3d_max(Vec3d a, Vec3d b) {
    return (Vec3d){fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z)};
}

/**
 * @return v with its largest component between 1/2 and 1, by a power of two: the same direction, to
 *         the bit, but squares of it neither overflow nor vanish.
 * @param v A finite vector that is not zero.
 */
static inline Vec3d vec3d_scale_exponent(Vec3d v) {
    int exponent;
    frexp(vec3d_max_abs(v), &exponent);
    return (Vec3d){ldexp(v.x, -exponent), ldexp(v.y, -exponent), ldexp(v.z, -exponent)};
}

/**
 * @return The length of v; neither a very long nor a very short vector overflows on the way.
 * @param v Any finite vector.
 */
static inline double vec3d_length(Vec3d v) {
    double largest = vec3d_max_abs(v);
    if (!(largest > 0)) {
        return 0;
    }
    Vec3d scaled = {v.x / largest, v.y / largest, v.z / largest};
    return largest * sqrt(vec3d_dot(scaled, scaled));
}

/** @return v with length 1. @param v A vector that is not zero. */
static inline Vec3d vec3d_normalize(Vec3d v) {
    double length = vec3d_length(v);
    return (Vec3d){v.x / length, v.y / length, v.z / length};
}

/** A bounding box along the axes, in double. */
typedef struct Aabbd {
    Vec3d low;  /**< Lowest corner. */
    Vec3d high; /**< Highest corner. */
} Aabbd;

/** @return A box without any point: each point that is added becomes its bounds. */
static inline Aabbd aabbd_empty(void) {
    return (Aabbd){{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
}

/** @return The box of all space. */
static inline Aabbd aabbd_infinite(void) {
    return (Aabbd){{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL, HUGE_VAL}};
}

/** @return The smallest box that holds a box and a point. @param box The box. @param p The point.
 */
static inline Aabbd aabbd_add_point(Aabbd box, Vec3d p) {
    return (Aabbd){{p.x < box.low.x ? p.x : box.low.x, p.y < box.low.y ? p.y : box.low.y,
                    p.z < box.low.z ? p.z : box.low.z},
                   {p.x > box.high.x ? p.x : box.high.x, p.y > box.high.y ? p.y : box.high.y,
                    p.z > box.high.z ? p.z : box.high.z}};
}

/** @return Whether a box is finite along all axes. @param box The box. */
static inline bool aabbd_is_bounded(Aabbd box) {
    return vec3d_max_abs(box.low) < HUGE_VAL && vec3d_max_abs(box.high) < HUGE_VAL;
}

#endif
