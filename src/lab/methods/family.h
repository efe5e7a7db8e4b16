/**
 * @file
 * @brief What a file of methods needs: the macros that define methods, and functions of the C
 *        library in the number type.
 */
#ifndef DIOPTRE_LAB_METHODS_FAMILY_H
#define DIOPTRE_LAB_METHODS_FAMILY_H

#include "lab/methods/method.h"
#include "trace/math/vec3.h"

/**
 * Begins the definition of a method, `static Output NAME(const Input *in)`, and defines NAME_run,
 * which calls it as a #Method.run. Input and Output are structs of nothing but `real`s.
 */
#define METHOD(name, Input, Output)                                                                \
    static Output name(const Input *in);                                                           \
    static void name##_run(const void *input, void *output) {                                      \
        *(Output *)output = name(input);                                                           \
    }                                                                                              \
    static Output name(const Input *in)

/** The first three members of a #MethodFamily. */
#define FAMILY(name, Input, Output)                                                                \
    name, (int)(sizeof(Input) / sizeof(real)), (int)(sizeof(Output) / sizeof(real))

extern const MethodFamily bounces_family;               /**< Reflections between four spheres. */
extern const MethodFamily box_slabs_family;             /**< A box by slabs. */
extern const MethodFamily box_cube_family;              /**< A cube, seen from inside. */
extern const MethodFamily cylinder_wall_family;         /**< The wall of a cylinder. */
extern const MethodFamily cylinder_solid_family;        /**< A closed cylinder. */
extern const MethodFamily domain_repetition_family;     /**< A sphere per cell of space. */
extern const MethodFamily fresnel_family;               /**< Reflectance of a dielectric. */
extern const MethodFamily gradient_family;              /**< Normals of a distance field. */
extern const MethodFamily intersector_disk_family;      /**< A disk. */
extern const MethodFamily intersector_cone_family;      /**< A cone between two circles. */
extern const MethodFamily intersector_ellipsoid_family; /**< An ellipsoid. */
extern const MethodFamily intersector_torus_family;     /**< A torus. */
extern const MethodFamily intersector_capsule_family;   /**< A capsule. */
extern const MethodFamily plane_family;                 /**< A plane. */
extern const MethodFamily ray_offset_family;            /**< Origins of secondary rays. */
extern const MethodFamily shells_family;                /**< Two spheres close to each other. */
extern const MethodFamily sphere_family;                /**< A sphere. */
extern const MethodFamily sphere_tracing_family;        /**< Steps along a ray to a surface. */
extern const MethodFamily sphere_uv_family;             /**< Latitude on a sphere. */
extern const MethodFamily triangle_family;              /**< A triangle. */

#if REAL_BITS == 32
/** A function of the C library in the number type. */
#define REAL_FUNCTION(name) __builtin_##name##f
#elif REAL_BITS == 64
#define REAL_FUNCTION(name) __builtin_##name
#elif REAL_BITS == 80 || !defined(__SIZEOF_FLOAT128__)
#define REAL_FUNCTION(name) __builtin_##name##l
#else
#define REAL_FUNCTION(name) name##f128
extern Quadruple fmaf128(Quadruple x, Quadruple y, Quadruple z);
extern Quadruple acosf128(Quadruple x);
extern Quadruple atan2f128(Quadruple y, Quadruple x);
extern Quadruple cosf128(Quadruple x);
extern Quadruple cbrtf128(Quadruple x);
#endif

/** @return x y + z, rounded once. */
static inline real real_fma(real x, real y, real z) {
    return REAL_FUNCTION(fma)(x, y, z);
}

/** @return The arc cosine, 0 to pi; NaN beyond -1 to 1. */
static inline real real_acos(real x) {
    return REAL_FUNCTION(acos)(x);
}

/** @return The cosine of an angle in radians. */
static inline real real_cos(real x) {
    return REAL_FUNCTION(cos)(x);
}

/** @return The cube root. */
static inline real real_cbrt(real x) {
    return REAL_FUNCTION(cbrt)(x);
}

/** @return The angle of the point (x, y), -pi to pi. */
static inline real real_atan2(real y, real x) {
    return REAL_FUNCTION(atan2)(y, x);
}

/** @return The smaller of two roots that is positive, or #INFINITE. @param near At most far. */
static inline real nearest_positive_root(real near, real far) {
    return near > 0 ? near : far > 0 ? far : INFINITE;
}

#endif
