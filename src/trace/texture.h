/**
 * @file
 * @brief Pictures on surfaces and in the sky, in the engine's number type.
 */
#ifndef DIOPTRE_TRACE_TEXTURE_H
#define DIOPTRE_TRACE_TEXTURE_H

#include "trace/shape_list.h"

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
 * Multiplies what surfaces send back by their pictures.
 * @param textures  The pictures; some are worn.
 * @param list      The shapes.
 * @param hit       What was met.
 * @param met       The lanes that met anything.
 * @param[in,out] body  The surfaces' colours.
 */
void textures_paint(const Textures *textures, const ShapeList *list, const Hit *hit, mask met,
                    Light3 *body);

/**
 * @return What the panorama shows.
 * @param textures   The pictures, with a panorama.
 * @param direction  Which way, of any length but 0.
 */
Light3 textures_panorama(const Textures *textures, Vector direction);

#endif
