/**
 * @file
 * @brief Refraction: which way light goes on where the medium changes, and how much is mirrored
 *        (doc/tour.md, "Glass"). Snell's law and Fresnel's shares (*Mémoire sur la loi des
 *        modifications que la réflexion imprime à la lumière polarisée*, 1823).
 */
#ifndef DIOPTRE_TRACE_REFRACTION_H
#define DIOPTRE_TRACE_REFRACTION_H

#include "trace/vector.h"

/** Half ulps that cos^2 of the refracted angle can be off, where the indices are the same. */
#define REFRACTION_ERROR 32

/** What becomes of LANES rays at an interface. */
typedef struct Refraction {
    Vector direction; /**< Of the refracted rays, one long; any where there is none. */
    real cosine;      /**< Of the angle between them and the normal. */
    real mirrored;    /**< Fresnel's F: the share that is mirrored. */
    mask is_total;    /**< Whether all is: there is no way to refract. */
} Refraction;

/**
 * @return Fresnel's share for light that is not polarised: the mean of the two polarisations.
 * @param cos_in   Cosine of the angle of incidence.
 * @param cos_out  Cosine of the refracted angle.
 * @param from     Index of refraction where the light comes from.
 * @param to       Where it goes to.
 */
INLINE real fresnel_share(real cos_in, real cos_out, real from, real to) {
    real across = (from * cos_in - to * cos_out) / (from * cos_in + to * cos_out);
    real along = (to * cos_in - from * cos_out) / (to * cos_in + from * cos_out);
    return (across * across + along * along) * (scalar)0.5f;
}

/**
 * @return What becomes of rays at an interface. Where the indices are the same, nothing at all
 * does, to the bit.
 * @param in      Which way they come, one long.
 * @param facing  The unit normal on the side that they come from.
 * @param from    Index of refraction on that side.
 * @param to      On the other.
 * @param doubt   How much, relatively, the angle of incidence is in doubt besides the roundings
 *                here: total reflection within it is called grazing, which looks the same.
 */
INLINE Refraction refraction_of(Vector in, Vector facing, real from, real to, real doubt) {
    const real one = real_of(1), zero = real_of(0);
    real cos_in = real_max(real_min(-vector_dot(in, facing), one), zero);
    real ratio = from / to, ratio_squared = ratio * ratio;
    // Snell: sin out = ratio sin in. No square is subtracted from 1, which would cancel.
    real cos_squared = 1 - ratio_squared * ((1 - cos_in) * (1 + cos_in));
    real slack = ratio_squared * (doubt + REFRACTION_ERROR * ROUNDOFF);
    real cos_out = real_sqrt(real_max(cos_squared, zero));
    Vector bent =
        vector_add(vector_scale(in, ratio), vector_scale(facing, ratio * cos_in - cos_out));
    mask is_same = from == to;
    mask is_total = mask_not(is_same) & (cos_squared < -slack);
    real share = real_select(is_total, one, fresnel_share(cos_in, cos_out, from, to));
    return (Refraction){.direction = vector_select(is_same, in, vector_normalize(bent)),
                        .cosine = real_select(is_same, cos_in, cos_out),
                        .mirrored = real_select(is_same, zero, share),
                        .is_total = is_total};
}

#endif
