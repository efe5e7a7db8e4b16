/**
 * @file
 * @brief A survey: what the rays of pixels do, in numbers instead of colours.
 */
#ifndef DIOPTRE_AOV_H
#define DIOPTRE_AOV_H

#include <stdint.h>

/** What is wanted besides what the camera's rays meet first; these can be added up. */
enum {
    AOV_RADIANCE = 1, /**< All rays are followed: colour, rays spent, lamps, the next surfaces. */
    AOV_STEPS = 2,    /**< The marching steps of the camera's rays. */
    AOV_UV = 4        /**< Where on a picture they meet the surfaces. */
};

/** Lamps that are told apart; of the others nothing is noted. */
enum { AOV_MAX_LIGHTS = 64 };

/** Rays that go on from the first surface: mirrored and refracted. */
enum { AOV_MAX_SECONDARY = 2 };

/** What is known of a pixel: of its camera's ray, and of what became of it. */
typedef struct AovSample {
    int shape;                /**< Place of the shape that it meets first; -1: none. */
    double distance;          /**< How far away, scene units; infinite where nothing is met. */
    double normal[3];         /**< The surface's unit normal there, outwards; zero where none is. */
    double uv[2];             /**< Where on a picture: (u, v); with #AOV_UV. */
    double color[3];          /**< What it brings back, linear; with #AOV_RADIANCE. */
    uint32_t ray_count;       /**< Rays of the pixel, of all kinds; with #AOV_RADIANCE. */
    uint32_t step_count;      /**< Steps that its march took; with #AOV_STEPS. */
    uint64_t lights_tested;   /**< Bit i: whether lamp i was asked there. */
    uint64_t lights_occluded; /**< Bit i: whether something stood between. */
    int secondary_shapes[AOV_MAX_SECONDARY]; /**< What the rays that go on meet, as #shape says it:
                                the mirrored one first. */
    uint32_t secondary_count;                /**< How many go on. */
} AovSample;

#endif
