/**
 * @file
 * @brief Textures of surfaces and of the sky.
 */
#ifndef DIOPTRE_TRACE_MATERIALS_TEXTURES_H
#define DIOPTRE_TRACE_MATERIALS_TEXTURES_H

#include "trace/tracer/surface_hit.h"

/** Values of an 8-bit channel of a texel. */
enum { TEXEL_LEVELS = 256 };

/** The textures of a scene. Starts as zero. */
typedef struct Textures {
    Texture **material_maps; /**< Per material its texture, shared, or NULL; the array is owned.
                                  NULL: no material has one. */
    size_t material_count;   /**< Number of materials. */
    Texture *sky;            /**< The environment map (equirectangular), shared; NULL: none. */
    scalar sky_rotation;     /**< The u of the environment map in direction -z. */
    scalar srgb_to_linear[TEXEL_LEVELS]; /**< The linear value of each 8-bit sRGB value. */
} Textures;

/**
 * Collects the textures that the materials and the sky of a scene use.
 * @param[out] textures  The textures; release them with #textures_deinit.
 * @param scene  The scene, with its image files loaded.
 * @return Whether memory sufficed.
 */
bool textures_init(Textures *textures, const Scene *scene, Error *error);

/** Releases the textures. */
void textures_deinit(Textures *textures);

/**
 * Samples the textures at the hits of a packet.
 * @param textures  The textures, with #Textures.material_maps.
 * @param[out] colors  The factors of the surfaces' colours; 1 where a material has no texture.
 */
void textures_sample(const Textures *textures, const ShapeSet *shapes, const SurfaceHit *surface,
                     Rgb *colors);

/**
 * @return The radiance of the environment map.
 * @param textures  The textures, with #Textures.sky.
 * @param direction  The directions, of any length but 0.
 * @param lanes  The lanes that are needed; others get black.
 */
Rgb textures_sample_sky(const Textures *textures, Vec3 direction, mask lanes);

#endif
