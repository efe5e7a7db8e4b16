/**
 * @file
 * @brief Materials in the engine's number type.
 */
#ifndef DIOPTRE_TRACE_MATERIALS_MATERIAL_H
#define DIOPTRE_TRACE_MATERIALS_MATERIAL_H

#include "trace/tracer/ray.h"

/**
 * The properties of a material: COLOR(name, value) or NUMBER(name, value). A new property is one
 * row here. The value comes from #SceneMaterial `scene` and the scene's `ambient_light`; `rest` is
 * max(0, 1 - R - T), the fraction of light that is neither reflected nor transmitted.
 */
#define MATERIAL_PROPERTIES(COLOR, NUMBER)                                                         \
    COLOR(emission, rgbs_of(scene->emission))                  /* Emitted radiance. */             \
    COLOR(albedo, rgbs_multiply(rest, rgbs_of(scene->color)))  /* Diffuse reflectance. */          \
    COLOR(specular, rgbs_scale(rest, (scalar)scene->specular)) /* Weight of highlights. */         \
    COLOR(reflectance, rgbs_of(scene->reflectivity))           /* R, of mirror reflection. */      \
    COLOR(transmittance, rgbs_of(scene->transparency))         /* T, of refraction. */             \
    COLOR(ambient, rgbs_scale(rgbs_of(ambient_light), (scalar)scene->ambient)) /* Weighted. */     \
    NUMBER(diffuse, (scalar)scene->diffuse)     /* Weight of diffuse light. */                     \
    NUMBER(shininess, (scalar)scene->shininess) /* Exponent of highlights. */

/** What light does at a material besides being scattered: a set of these. */
enum {
    MATERIAL_SHINES = 1, /**< It has highlights. */
    MATERIAL_TURNS = 2   /**< It reflects or transmits rays. */
};

/** A material. See #MATERIAL_PROPERTIES. */
typedef struct Material {
#define COLOR(name, value) Rgbs name;
#define NUMBER(name, value) scalar name;
    MATERIAL_PROPERTIES(COLOR, NUMBER)
#undef COLOR
#undef NUMBER
    unsigned traits; /**< #MATERIAL_SHINES, #MATERIAL_TURNS. */
} Material;

/** The materials at the hits of LANES rays. See #MATERIAL_PROPERTIES. */
typedef struct MaterialPack {
#define COLOR(name, value) Rgb name;
#define NUMBER(name, value) real name;
    MATERIAL_PROPERTIES(COLOR, NUMBER)
#undef COLOR
#undef NUMBER
} MaterialPack;

/** @return A material in the engine's number type. */
Material material_of(const SceneMaterial *scene, Rgbd ambient_light);

/** @return A material in all lanes. */
INLINE MaterialPack material_pack_splat(const Material *material) {
#define COLOR(name, value) .name = rgb_splat(material->name),
#define NUMBER(name, value) .name = real_of(material->name),
    return (MaterialPack){MATERIAL_PROPERTIES(COLOR, NUMBER)};
#undef COLOR
#undef NUMBER
}

/** @return a where the mask is set, b elsewhere. */
INLINE MaterialPack material_pack_select(mask m, const MaterialPack *a, const MaterialPack *b) {
#define COLOR(name, value) .name = rgb_select(m, a->name, b->name),
#define NUMBER(name, value) .name = real_select(m, a->name, b->name),
    return (MaterialPack){MATERIAL_PROPERTIES(COLOR, NUMBER)};
#undef COLOR
#undef NUMBER
}

/** @return emission + albedo (ambient + diffuse D): the radiance of a matt surface. @param light
 * Its sum D of direct light. */
INLINE Rgb diffuse_color(const MaterialPack *material, Rgb light) {
    Rgb all = rgb_add(material->ambient, rgb_scale(light, material->diffuse));
    return rgb_add(material->emission, rgb_multiply(material->albedo, all));
}

/** The indices of the materials at the hits of LANES rays. Mostly all are equal, for neighbouring
 *  rays hit the same shape. */
typedef struct MaterialIds {
    integer ids; /**< Index per lane. */
    int first;   /**< Index in the first lane with a hit. */
    mask others; /**< The lanes whose hits have another shape, and so perhaps another material. */
} MaterialIds;

/**
 * @return The materials at the hits of LANES rays. Inlined, so that the compiler loads only the
 *         properties that the caller uses.
 * @param active  The lanes that are needed; others get any material.
 */
INLINE MaterialPack material_pack_gather(const Material *materials, const MaterialIds *ids,
                                         mask active) {
    MaterialPack gathered = material_pack_splat(&materials[ids->first]);
    mask remaining = active & ids->others;
    // One iteration per further material.
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
 * @return base to the power of exponent: by repeated squaring for the integer part of the exponent,
 *         and by square roots for its fraction. Only correctly rounded operations are used, so
 * every machine gets the same bits (the pow of C libraries differs). The relative error is about
 *         `exponent` half ulps, no more than one rounding of the base causes.
 */
real real_pow(real base, real exponent);

#endif
