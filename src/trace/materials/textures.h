/**
 * @file
 * @brief Pictures on surfaces and in the sky, in the engine's number type.
 */
#ifndef DIOPTRE_TRACE_MATERIALS_TEXTURES_H
#define DIOPTRE_TRACE_MATERIALS_TEXTURES_H

#include "trace/tracer/surface_hit.h"

/** Steps of a texel that is no light. */
enum { TEXEL_LEVELS = 256 };

/** The pictures of a scene. Starts as zero. */
typedef struct Textures {
    Texture **material_maps; /**< For each material its picture, shared, or NULL; owned. NULL:
                         no shape shows any. */
    size_t material_count;   /**< How many materials. */
    Texture *sky;            /**< The panorama, shared, or NULL. */
    scalar sky_rotation;     /**< Where the panorama is ahead (-z): 0 its left edge, 1/2 its
                          middle. */
    scalar srgb_to_linear[TEXEL_LEVELS]; /**< The light that each step stands for. */
} Textures;

/**
 * Takes the pictures that a scene shows, and no others.
 * @param[out] textures  The pictures; give them back with #textures_deinit.
 * @param scene  The scene, its picture files read.
 * @return false without memory.
 */
bool textures_init(Textures *textures, const Scene *scene, Error *error);

/** Gives pictures back. */
void textures_deinit(Textures *textures);

/**
 * Finds what the pictures show at the points that a packet of rays has met.
 * @param textures  The pictures; some are worn.
 * @param[out] colors  What multiplies the colours of their surfaces; 1 where there is no picture.
 */
void textures_sample(const Textures *textures, const ShapeSet *shapes, const SurfaceHit *surface,
                     Rgb *colors);

/**
 * @return What the panorama shows.
 * @param textures   The pictures, with a panorama.
 * @param direction  Which way, of any length but 0.
 * @param lanes      The lanes that count; the others get black.
 */
Rgb textures_sample_sky(const Textures *textures, Vec3 direction, mask lanes);

#endif
