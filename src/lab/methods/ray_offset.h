/**
 * @file
 * @brief Where does a ray start that leaves a surface? What is asked, and answered.
 *
 * A ray meets a sphere; from there a second ray leaves, mirrored or refracted. It must not meet the
 * same place again, must meet what comes after it, and should not start far away.
 */
#ifndef DIOPTRE_LAB_METHODS_RAY_OFFSET_H
#define DIOPTRE_LAB_METHODS_RAY_OFFSET_H

#include "lab/methods/method.h"
#include "trace/math/vec3.h"

/** A ray and a sphere. */
typedef struct RayOffsetInput {
    Vec3 origin;    /**< Where the first ray starts. */
    Vec3 direction; /**< Which way, of length 1 but for rounding. */
    Vec3 center;    /**< The sphere's centre. */
    real radius;    /**< Its radius. */
    real ratio;     /**< For refraction: index outside over index inside; 0: mirrored. */
} RayOffsetInput;

/** What becomes of the second ray. */
typedef struct RayOffsetOutput {
    real distance; /**< Where it meets the sphere again; #INFINITE: nowhere. */
    real shift;    /**< How far from the first point it starts. */
} RayOffsetOutput;

/** Where the first ray met the sphere, and what leaves from there. */
typedef struct RayOffsetHit {
    Vec3 point;    /**< The point. */
    Vec3 normal;   /**< The normal, outwards. */
    Vec3 outgoing; /**< Which way the second ray goes. */
} RayOffsetHit;

/** A second ray. */
typedef struct RayOffsetStart {
    Vec3 origin; /**< Where it starts. */
    real t_min;  /**< What is nearer than this is no meeting. */
} RayOffsetStart;

/** @return What leaves. */
RayOffsetHit ray_offset_hit(const RayOffsetInput *in);

/** @return What becomes of the second ray. */
RayOffsetOutput ray_offset_output_of(const RayOffsetInput *in, const RayOffsetHit *hit,
                                     const RayOffsetStart *start);

#endif
