/**
 * @file
 * @brief Surfaces: materials in the engine's number type, and what they do with light.
 */
#ifndef DIOPTRE_TRACE_MATERIALS_MATERIAL_H
#define DIOPTRE_TRACE_MATERIALS_MATERIAL_H

#include "trace/tracer/ray.h"

/** A material. What is neither mirrored nor let through is left to the body: its weights hold the
 *  factor 1 - R - T. */
typedef struct Material {
    Rgbs emission;      /**< Light of its own. */
    Rgbs albedo;        /**< (1 - R - T) times the colour. */
    Rgbs specular;      /**< (1 - R - T) times the weight of highlights. */
    Rgbs reflectance;   /**< R: the share that is mirrored. */
    Rgbs transmittance; /**< T: the share that is let through. */
    Rgbs ambient;       /**< Light from everywhere, weighted. */
    scalar diffuse;     /**< Weight of the lights' matt shine. */
    scalar shininess;   /**< Exponent of highlights. */
} Material;

/** The materials that LANES rays have met. */
typedef struct MaterialPack {
    Rgb emission;      /**< See #Material. */
    Rgb albedo;        /**< See #Material. */
    Rgb specular;      /**< See #Material. */
    Rgb reflectance;   /**< See #Material. */
    Rgb transmittance; /**< See #Material. */
    Rgb ambient;       /**< See #Material. */
    real diffuse;      /**< See #Material. */
    real shininess;    /**< See #Material. */
} MaterialPack;

/** @return A material in the engine's number type. */
Material material_of(const SceneMaterial *material, Rgbd ambient);

/** @return A material in all lanes. */
INLINE MaterialPack material_pack_splat(const Material *s) {
    return (MaterialPack){.emission = rgb_splat(s->emission),
                          .albedo = rgb_splat(s->albedo),
                          .specular = rgb_splat(s->specular),
                          .reflectance = rgb_splat(s->reflectance),
                          .transmittance = rgb_splat(s->transmittance),
                          .ambient = rgb_splat(s->ambient),
                          .diffuse = real_of(s->diffuse),
                          .shininess = real_of(s->shininess)};
}

/** @return a where the mask is set, b elsewhere. */
INLINE MaterialPack material_pack_select(mask m, const MaterialPack *a, const MaterialPack *b) {
    return (MaterialPack){.emission = rgb_select(m, a->emission, b->emission),
                          .albedo = rgb_select(m, a->albedo, b->albedo),
                          .specular = rgb_select(m, a->specular, b->specular),
                          .reflectance = rgb_select(m, a->reflectance, b->reflectance),
                          .transmittance = rgb_select(m, a->transmittance, b->transmittance),
                          .ambient = rgb_select(m, a->ambient, b->ambient),
                          .diffuse = real_select(m, a->diffuse, b->diffuse),
                          .shininess = real_select(m, a->shininess, b->shininess)};
}

/** Places of the materials that LANES rays have met: mostly one, for neighbours meet the same. */
typedef struct MaterialIds {
    integer ids; /**< Place of each lane's material. */
    int first;   /**< Place of one of them. */
    mask others; /**< The lanes that met something and not this one. */
} MaterialIds;

/**
 * @return What LANES rays have met. Part of its callers, so that each reads only the members that
 *         it uses.
 * @param active  The lanes that count; the others get any material.
 */
INLINE MaterialPack material_pack_gather(const Material *materials, const MaterialIds *ids,
                                         mask active) {
    MaterialPack gathered = material_pack_splat(&materials[ids->first]);
    mask remaining = active & ids->others;
    // One more turn for each different material.
    while (any(remaining)) {
        int material = integer_lane(ids->ids, mask_first(remaining));
        mask same = remaining & (ids->ids == integer_of(material));
        MaterialPack one = material_pack_splat(&materials[material]);
        gathered = material_pack_select(same, &one, &gathered);
        remaining &= mask_not(same);
    }
    return gathered;
}

/**
 * @return base to the power of exponent: by squares for the whole part of the exponent and square
 *         roots for the rest, so only correctly rounded operations are used and every machine gets
 *         the same bits (a C library's pow may differ). The error is about `exponent` half ulps, no
 *         more than one rounding of the base would cause.
 */
real real_pow(real base, real exponent);

#endif
