/**
 * @file
 * @brief Surfaces: materials in the engine's number type, and what they do with light.
 */
#ifndef DIOPTRE_TRACE_SURFACE_H
#define DIOPTRE_TRACE_SURFACE_H

#include "trace/ray.h"

/** A material. What is neither mirrored nor let through is left to the body: its weights hold the
 *  factor 1 - R - T. */
typedef struct Surface {
    Scalar3 emission;  /**< Light of its own. */
    Scalar3 body;      /**< (1 - R - T) times the colour. */
    Scalar3 highlight; /**< (1 - R - T) times the weight of highlights. */
    Scalar3 mirror;    /**< R: the share that is mirrored. */
    Scalar3 through;   /**< T: the share that is let through. */
    Scalar3 ambient;   /**< Light from everywhere, weighted. */
    scalar diffuse;    /**< Weight of the lights' matt shine. */
    scalar shininess;  /**< Exponent of highlights. */
} Surface;

/** The materials that LANES rays have met. */
typedef struct Surfaces {
    Light3 emission;  /**< See #Surface. */
    Light3 body;      /**< See #Surface. */
    Light3 highlight; /**< See #Surface. */
    Light3 mirror;    /**< See #Surface. */
    Light3 through;   /**< See #Surface. */
    Light3 ambient;   /**< See #Surface. */
    real diffuse;     /**< See #Surface. */
    real shininess;   /**< See #Surface. */
} Surfaces;

/** @return A material in the engine's number type. @param material It. @param ambient The scene's.
 */
Surface surface_of(const Material *material, Color ambient);

/** @return A material in all lanes. @param s The material. */
INLINE Surfaces surfaces_of(const Surface *s) {
    return (Surfaces){.emission = light3_of(s->emission),
                      .body = light3_of(s->body),
                      .highlight = light3_of(s->highlight),
                      .mirror = light3_of(s->mirror),
                      .through = light3_of(s->through),
                      .ambient = light3_of(s->ambient),
                      .diffuse = real_of(s->diffuse),
                      .shininess = real_of(s->shininess)};
}

/** @return a where the mask is set, b elsewhere. @param m A mask. @param a Some. @param b Others.
 */
INLINE Surfaces surfaces_select(mask m, const Surfaces *a, const Surfaces *b) {
    return (Surfaces){.emission = light3_select(m, a->emission, b->emission),
                      .body = light3_select(m, a->body, b->body),
                      .highlight = light3_select(m, a->highlight, b->highlight),
                      .mirror = light3_select(m, a->mirror, b->mirror),
                      .through = light3_select(m, a->through, b->through),
                      .ambient = light3_select(m, a->ambient, b->ambient),
                      .diffuse = real_select(m, a->diffuse, b->diffuse),
                      .shininess = real_select(m, a->shininess, b->shininess)};
}

/** Places of the materials that LANES rays have met: mostly one, for neighbours meet the same. */
typedef struct Materials {
    integer places; /**< Place of each lane's material. */
    int first;      /**< Place of one of them. */
    mask others;    /**< The lanes that met something and not this one. */
} Materials;

/**
 * @return What LANES rays have met. Part of its callers, so that each reads only the members that
 * it uses.
 * @param surfaces   All materials.
 * @param materials  The materials met.
 * @param active     The lanes that count; the others get any material.
 */
INLINE Surfaces surfaces_gather(const Surface *surfaces, const Materials *materials, mask active) {
    Surfaces gathered = surfaces_of(&surfaces[materials->first]);
    mask left = active & materials->others;
    // One more turn for each different material.
    while (any(left)) {
        int material = integer_lane(materials->places, mask_first(left));
        mask same = left & (materials->places == integer_of(material));
        Surfaces one = surfaces_of(&surfaces[material]);
        gathered = surfaces_select(same, &one, &gathered);
        left &= mask_not(same);
    }
    return gathered;
}

/**
 * @return base to the power of exponent: by squares for the whole part of the exponent and square
 *         roots for the rest, so only correctly rounded operations are used and every machine gets
 *         the same bits (a C library's pow may differ). The error is about `exponent` half ulps,
 *         no more than one rounding of the base would cause.
 * @param base      0 to 1.
 * @param exponent  At least 0.
 */
real surface_power(real base, real exponent);

#endif
