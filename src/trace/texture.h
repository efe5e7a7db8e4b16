/**
 * @file
 * @brief Pictures on surfaces and in the sky, in the engine's number type.
 */
#ifndef DIOPTRE_TRACE_TEXTURE_H
#define DIOPTRE_TRACE_TEXTURE_H

#include "trace/lighting.h"

/** Steps of a texel that is no light. */
enum { TEXEL_STEPS = 256 };

/** The pictures of a scene. Starts as zero. */
typedef struct Textures {
    Texture **worn;            /**< For each material its picture, shared, or NULL; owned. NULL:
                                    no shape shows any. */
    size_t material_count;     /**< How many materials. */
    Texture *sky;              /**< The panorama, shared, or NULL. */
    scalar turn;               /**< Where the panorama is ahead (-z): 0 its left edge, 1/2 its
                                    middle. */
    scalar light[TEXEL_STEPS]; /**< The light that each step stands for. */
} Textures;

/**
 * Takes the pictures that a scene shows, and no others.
 * @param[out] textures  The pictures; give them back with #textures_release.
 * @param scene          The scene, its picture files read.
 * @param[out] error     What is wrong.
 * @return false without memory.
 */
bool textures_init(Textures *textures, const Scene *scene, Error *error);

/** Gives pictures back. @param textures The pictures. */
void textures_release(Textures *textures);

/**
 * Finds what the pictures show at the points that a packet of rays has met.
 * @param textures  The pictures; some are worn.
 * @param list      The shapes.
 * @param met       The points.
 * @param[out] paint  What multiplies the colours of their surfaces; 1 where there is no picture.
 */
void textures_paint(const Textures *textures, const ShapeList *list, const Encounter *met,
                    Light3 *paint);

/**
 * @return What the panorama shows.
 * @param textures   The pictures, with a panorama.
 * @param direction  Which way, of any length but 0.
 * @param lanes      The lanes that count; the others get black.
 */
Light3 textures_panorama(const Textures *textures, Vector direction, mask lanes);

#endif
