/**
 * @file
 * @brief Arbitrary output variables (AOVs): numbers of the rays of a pixel, for debug views.
 */
#ifndef DIOPTRE_AOV_H
#define DIOPTRE_AOV_H

#include <stdint.h>

/** Optional AOVs, as bits of a mask. The first hit of the camera ray is always there. */
enum {
    AOV_RADIANCE = 1, /**< From full shading: colour, ray count, lights, secondary hits. */
    AOV_STEPS = 2,    /**< The sphere-tracing steps of the camera ray. */
    AOV_UV = 4        /**< Texture coordinates of the first hit. */
};

/** Lights with a bit of their own; further lights are not recorded. */
enum { AOV_MAX_LIGHTS = 64 };

/** Secondary rays of the first hit: reflected and refracted. */
enum { AOV_MAX_SECONDARY = 2 };

/** The AOVs of one pixel. */
typedef struct AovSample {
    int shape;                /**< Index of the shape hit first; -1: none. */
    double distance;          /**< Distance to it, scene units; infinite without a hit. */
    double normal[3];         /**< Outward unit normal there; zero without a hit. */
    double uv[2];             /**< Texture coordinates; with #AOV_UV. */
    double color[3];          /**< Radiance, linear; with #AOV_RADIANCE. */
    uint32_t ray_count;       /**< Rays of the pixel, of all kinds; with #AOV_RADIANCE. */
    uint32_t step_count;      /**< Sphere-tracing steps; with #AOV_STEPS. */
    uint64_t lights_tested;   /**< Bit i: light i has a shadow ray there. */
    uint64_t lights_occluded; /**< Bit i: that shadow ray is occluded. */
    int secondary_shapes[AOV_MAX_SECONDARY]; /**< Shapes that secondary rays hit, as
                                #shape; the reflected one first. */
    uint32_t secondary_count;                /**< Number of secondary rays. */
} AovSample;

#endif
