/**
 * @file
 * @brief Points, vectors and colours of a scene, in double precision.
 *
 * Conventions of the whole program: right-handed axes, x to the right, y up; the default camera
 * looks along -z. Angles are degrees in files and radians in computations. Colours are linear
 * light; only the finished picture is encoded.
 */
#ifndef DIOPTRE_BASE_VEC3D_H
#define DIOPTRE_BASE_VEC3D_H

#include <float.h>
#include <math.h>
#include <stdbool.h>

/** A point (scene units) or a direction in space. */
typedef struct Vec3d {
    double x; /**< To the right. */
    double y; /**< Up. */
    double z; /**< Towards the viewer. */
} Vec3d;

/** Texture coordinates. */
typedef struct Uvd {
    double u; /**< To the right. */
    double v; /**< Up. */
} Uvd;

/** A colour in linear light, three primaries; 1 is the brightest that a picture can show. */
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

/** @return s v. @param v A vector. @param s A factor. */
static inline Vec3d vec3d_scale(Vec3d v, double s) {
    return (Vec3d){v.x * s, v.y * s, v.z * s};
}

/** @return The dot product a . b. @param a A vector. @param b Another. */
static inline double vec3d_dot(Vec3d a, Vec3d b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return The cross product a x b, perpendicular to both. @param a A vector. @param b Another. */
static inline Vec3d vec3d_cross(Vec3d a, Vec3d b) {
    return (Vec3d){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** @return The largest absolute component. @param v A vector. */
static inline double vec3d_max_abs(Vec3d v) {
    return fmax(fabs(v.x), fmax(fabs(v.y), fabs(v.z)));
}

/** @return The minimum of each component. @param a A point. @param b Another. */
static inline Vec3d vec3d_min(Vec3d a, Vec3d b) {
    return (Vec3d){fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z)};
}

/** @return The maximum of each component. @param a A point. @param b Another. */
static inline Vec3d vec3d_max(Vec3d a, Vec3d b) {
    return (Vec3d){fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z)};
}

/**
 * @return v times a power of two, so that its largest component is between 1/2 and 1. The direction
 *         is exactly the same, and squares neither overflow nor underflow.
 * @param v A finite vector, not zero.
 */
static inline Vec3d vec3d_scale_exponent(Vec3d v) {
    int exponent;
    frexp(vec3d_max_abs(v), &exponent);
    return (Vec3d){ldexp(v.x, -exponent), ldexp(v.y, -exponent), ldexp(v.z, -exponent)};
}

/**
 * @return The length of v, without overflow or underflow of its squares.
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

/** @return The unit vector along v. @param v A vector, not zero. */
static inline Vec3d vec3d_normalize(Vec3d v) {
    double length = vec3d_length(v);
    return (Vec3d){v.x / length, v.y / length, v.z / length};
}

/**
 * @return Whether a vector has a direction, and so can be normalised. Below the smallest normal
 *         number its length loses digits.
 */
static inline bool vec3d_has_direction(Vec3d v) {
    return vec3d_length(v) >= DBL_MIN;
}

/** A bounding box along the axes, in double. */
typedef struct Aabbd {
    Vec3d low;  /**< Lowest corner. */
    Vec3d high; /**< Highest corner. */
} Aabbd;

/** @return An empty box; #aabbd_add_point extends it. */
static inline Aabbd aabbd_empty(void) {
    return (Aabbd){{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
}

/** @return The box of all space. */
static inline Aabbd aabbd_infinite(void) {
    return (Aabbd){{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}, {HUGE_VAL, HUGE_VAL, HUGE_VAL}};
}

/**
 * @return The smallest box that contains a box and a point.
 * @param box  The box.
 * @param p    The point.
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
