/**
 * @file
 * @brief What rounding does at a hit: the surface in quadruple precision, the point that the engine
 * rounded, and where the next rays start, all on the normal.
 */
#ifndef DIOPTRE_RENDER_RAY_MICROSCOPE_H
#define DIOPTRE_RENDER_RAY_MICROSCOPE_H

#include "dioptre/renderer.h"

/** Most rays that leave a hit and are shown. */
enum { MICROSCOPE_RAYS = 16 };

/** A ray that leaves the hit. */
typedef struct MicroscopeRay {
    size_t ray;    /**< Its index in the tree. */
    double height; /**< Of its origin over the surface, ulps. */
} MicroscopeRay;

/** A hit, magnified. Heights are along the outward normal, from the surface as quadruple precision
 *  has it. Starts as `{0}`. */
typedef struct RayMicroscope {
    bool is_valid;     /**< Whether there is a hit, and a wider number type to measure it in. */
    double ulp;        /**< An ulp of the largest coordinate of the hit, scene units. */
    double height;     /**< Of the rounded point, ulps. */
    double epsilon;    /**< Offset of the next rays, ulps. */
    size_t next_count; /**< Number of #next. */
    MicroscopeRay next[MICROSCOPE_RAYS]; /**< The rays that leave it. */
} RayMicroscope;

/**
 * Measures the hit of a ray.
 * @param engine  The engine that traced it.
 * @param index   Of the ray in its tree.
 * @return The hit; not valid for a ray without one, a shadow ray, or the widest number type.
 */
RayMicroscope ray_microscope_measure(const Engine *engine, const Scene *scene, const RayTree *tree,
                                     size_t index);

#endif
