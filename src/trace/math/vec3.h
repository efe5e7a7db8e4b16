/**
 * @file
 * @brief Points, directions and colours in the engine's number type.
 *
 * Suffixes name the representation: Vec3 is LANES of them, Vec3s one, Vec3w LANES in the next wider
 * type, Vec3sw one in that; Vec3d (src/base/vec3d.h) is the scene's, in double.
 */
#ifndef DIOPTRE_TRACE_MATH_VEC3_H
#define DIOPTRE_TRACE_MATH_VEC3_H

#include "trace/math/wide.h"

/** LANES points or directions. */
typedef struct Vec3 {
    real x; /**< To the right. */
    real y; /**< Up. */
    real z; /**< Towards the viewer. */
} Vec3;

/** LANES points or directions in the next wider type. */
typedef struct Vec3w {
    wide x; /**< To the right. */
    wide y; /**< Up. */
    wide z; /**< Towards the viewer. */
} Vec3w;

/** One point or direction in the next wider type, in which shapes store theirs. */
typedef struct Vec3sw {
    wide_scalar x; /**< To the right. */
    wide_scalar y; /**< Up. */
    wide_scalar z; /**< Towards the viewer. */
} Vec3sw;

/** One point or direction. */
typedef struct Vec3s {
    scalar x; /**< To the right. */
    scalar y; /**< Up. */
    scalar z; /**< Towards the viewer. */
} Vec3s;

/** LANES linear RGB colours. */
typedef struct Rgb {
    real red;   /**< Red. */
    real green; /**< Green. */
    real blue;  /**< Blue. */
} Rgb;

/** One linear RGB colour. */
typedef struct Rgbs {
    scalar red;   /**< Red. */
    scalar green; /**< Green. */
    scalar blue;  /**< Blue. */
} Rgbs;

/* --- conversion ------------------------------------------------------------------------------- */

/** @return A vector of the scene, rounded, in all lanes. */
INLINE Vec3 vec3_of(Vec3d v) {
    return (Vec3){real_of((scalar)v.x), real_of((scalar)v.y), real_of((scalar)v.z)};
}

/** @return A vector of the scene; of float and double engines exactly. */
INLINE Vec3sw vec3sw_of(Vec3d v) {
    return (Vec3sw){(wide_scalar)v.x, (wide_scalar)v.y, (wide_scalar)v.z};
}

/** @return A vector in double, rounded. */
INLINE Vec3d vec3d_of(Vec3sw p) {
    return (Vec3d){(double)p.x, (double)p.y, (double)p.z};
}

/** @return A vector in all lanes. */
INLINE Vec3w vec3w_splat(Vec3sw p) {
    return (Vec3w){wide_of(p.x), wide_of(p.y), wide_of(p.z)};
}

/** @return The nearest vector. */
INLINE Vec3s vec3s_narrow(Vec3sw p) {
    return (Vec3s){(scalar)p.x, (scalar)p.y, (scalar)p.z};
}

/** @return A vector that is the same in all lanes. */
INLINE Vec3s vec3s_first_lane(Vec3 v) {
    return (Vec3s){real_lane(v.x, 0), real_lane(v.y, 0), real_lane(v.z, 0)};
}

/** @return The same numbers, exactly. */
INLINE Vec3sw vec3s_widen(Vec3s p) {
    return (Vec3sw){(wide_scalar)p.x, (wide_scalar)p.y, (wide_scalar)p.z};
}

/** @return A vector in all lanes. */
INLINE Vec3 vec3_splat(Vec3s p) {
    return (Vec3){real_of(p.x), real_of(p.y), real_of(p.z)};
}

/** @return One of LANES points in all lanes. */
INLINE Vec3 vec3_splat_lane(const Vec3 *v, int lane) {
    return (Vec3){real_of(real_at(&v->x, lane)), real_of(real_at(&v->y, lane)),
                  real_of(real_at(&v->z, lane))};
}

/** @return The same numbers, exactly. */
INLINE Vec3w vec3_widen(Vec3 v) {
    return (Vec3w){widen(v.x), widen(v.y), widen(v.z)};
}

/** @return The nearest numbers of the engine's type. */
INLINE Vec3 vec3_narrow(Vec3w v) {
    return (Vec3){narrow(v.x), narrow(v.y), narrow(v.z)};
}

/* --- arithmetic ------------------------------------------------------------------------------- */

/** @return a + b. */
INLINE Vec3 vec3_add(Vec3 a, Vec3 b) {
    return (Vec3){a.x + b.x, a.y + b.y, a.z + b.z};
}

/** @return a - b. */
INLINE Vec3 vec3_subtract(Vec3 a, Vec3 b) {
    return (Vec3){a.x - b.x, a.y - b.y, a.z - b.z};
}

/** @return s v. */
INLINE Vec3 vec3_scale(Vec3 v, real s) {
    return (Vec3){v.x * s, v.y * s, v.z * s};
}

/** @return a . b, summed in the order x, y, z. */
INLINE real vec3_dot(Vec3 a, Vec3 b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return a x b. */
INLINE Vec3 vec3_cross(Vec3 a, Vec3 b) {
    return (Vec3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** @return The sum of the absolute values of the components: no less than the length. */
INLINE real vec3_abs_sum(Vec3 v) {
    return real_abs(v.x) + real_abs(v.y) + real_abs(v.z);
}

/** @return v / |v|; v must not be zero. */
INLINE Vec3 vec3_normalize(Vec3 v) {
    return vec3_scale(v, 1 / real_sqrt(vec3_dot(v, v)));
}

/** @return A component. @param axis 0, 1 or 2 for x, y or z. */
INLINE real vec3_component(const Vec3 *v, int axis) {
    return axis == 0 ? v->x : axis == 1 ? v->y : v->z;
}

/** @return The address of a component. @param axis See vec3_component(); no branch depends on it.
 */
INLINE const real *vec3_axis(const Vec3 *v, int axis) {
    return &v->x + axis;
}

/** @return The maximum norm. */
INLINE real vec3_max_abs(Vec3 v) {
    return real_max(real_abs(v.x), real_max(real_abs(v.y), real_abs(v.z)));
}

/** @return The minimum of each component; that of b if either is NaN. */
INLINE Vec3 vec3_min(Vec3 a, Vec3 b) {
    return (Vec3){real_min(a.x, b.x), real_min(a.y, b.y), real_min(a.z, b.z)};
}

/** @return The maximum of each component; that of b if either is NaN. */
INLINE Vec3 vec3_max(Vec3 a, Vec3 b) {
    return (Vec3){real_max(a.x, b.x), real_max(a.y, b.y), real_max(a.z, b.z)};
}

/** @return a where the mask is set, b elsewhere. */
INLINE Vec3 vec3_select(mask m, Vec3 a, Vec3 b) {
    return (Vec3){real_select(m, a.x, b.x), real_select(m, a.y, b.y), real_select(m, a.z, b.z)};
}

/** @return a - b. */
INLINE Vec3w vec3w_subtract(Vec3w a, Vec3w b) {
    return (Vec3w){a.x - b.x, a.y - b.y, a.z - b.z};
}

/** @return s v. */
INLINE Vec3w vec3w_scale(Vec3w v, wide s) {
    return (Vec3w){v.x * s, v.y * s, v.z * s};
}

/** @return a where the mask is set, b elsewhere. */
INLINE Vec3w vec3w_select(wide_mask m, Vec3w a, Vec3w b) {
    return (Vec3w){wide_select(m, a.x, b.x), wide_select(m, a.y, b.y), wide_select(m, a.z, b.z)};
}

/** @return a + s v. */
INLINE Vec3w vec3w_add_scaled(Vec3w a, Vec3w v, wide s) {
    return (Vec3w){a.x + v.x * s, a.y + v.y * s, a.z + v.z * s};
}

/** @return a . b, summed in the order x, y, z. */
INLINE wide vec3w_dot(Vec3w a, Vec3w b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return a x b. */
INLINE Vec3w vec3w_cross(Vec3w a, Vec3w b) {
    return (Vec3w){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** @return The absolute value. */
INLINE scalar scalar_abs(scalar x) {
    return x < 0 ? -x : x;
}

/** @return a + b. */
INLINE Vec3s vec3s_add(Vec3s a, Vec3s b) {
    return (Vec3s){a.x + b.x, a.y + b.y, a.z + b.z};
}

/** @return s v. */
INLINE Vec3s vec3s_scale(Vec3s v, scalar s) {
    return (Vec3s){v.x * s, v.y * s, v.z * s};
}

/** @return a . b. */
INLINE scalar vec3s_dot(Vec3s a, Vec3s b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return The sum of the absolute values of the components: no less than the length. */
INLINE scalar vec3s_abs_sum(Vec3s v) {
    return scalar_abs(v.x) + scalar_abs(v.y) + scalar_abs(v.z);
}

/** @return a - b. */
static inline Vec3sw vec3sw_subtract(Vec3sw a, Vec3sw b) {
    return (Vec3sw){a.x - b.x, a.y - b.y, a.z - b.z};
}

/** @return s v. */
static inline Vec3sw vec3sw_scale(Vec3sw v, wide_scalar s) {
    return (Vec3sw){v.x * s, v.y * s, v.z * s};
}

/** @return a . b. */
static inline wide_scalar vec3sw_dot(Vec3sw a, Vec3sw b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/** @return a x b. */
static inline Vec3sw vec3sw_cross(Vec3sw a, Vec3sw b) {
    return (Vec3sw){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/** @return v / |v|. */
static inline Vec3sw vec3sw_normalize(Vec3sw v) {
    wide_scalar length = (wide_scalar)WIDE_SQRT(v.x * v.x + v.y * v.y + v.z * v.z);
    return (Vec3sw){v.x / length, v.y / length, v.z / length};
}

/* --- colours ---------------------------------------------------------------------------------- */

/** @return A colour of the scene, rounded. */
INLINE Rgbs rgbs_of(Rgbd c) {
    return (Rgbs){(scalar)c.red, (scalar)c.green, (scalar)c.blue};
}

/** @return A colour in all lanes. */
INLINE Rgb rgb_splat(Rgbs c) {
    return (Rgb){real_of(c.red), real_of(c.green), real_of(c.blue)};
}

/** @return a + b. */
INLINE Rgb rgb_add(Rgb a, Rgb b) {
    return (Rgb){a.red + b.red, a.green + b.green, a.blue + b.blue};
}

/** @return a times b, channel by channel. */
INLINE Rgb rgb_multiply(Rgb a, Rgb b) {
    return (Rgb){a.red * b.red, a.green * b.green, a.blue * b.blue};
}

/** @return a times s. */
INLINE Rgb rgb_scale(Rgb a, real s) {
    return (Rgb){a.red * s, a.green * s, a.blue * s};
}

/** @return The largest channel. */
INLINE real rgb_max(Rgb a) {
    return real_max(a.red, real_max(a.green, a.blue));
}

/** @return a where the mask is set, b elsewhere. */
INLINE Rgb rgb_select(mask m, Rgb a, Rgb b) {
    return (Rgb){real_select(m, a.red, b.red), real_select(m, a.green, b.green),
                 real_select(m, a.blue, b.blue)};
}

#endif
