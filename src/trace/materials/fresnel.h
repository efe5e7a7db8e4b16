/**
 * @file
 * @brief Refraction: which way light goes on where the medium changes, and how much is mirrored
 *        (doc/tour.md, "Glass"). Snell's law and Fresnel's shares (*Mémoire sur la loi des
 *        modifications que la réflexion imprime à la lumière polarisée*, 1823).
 */
#ifndef DIOPTRE_TRACE_MATERIALS_FRESNEL_H
#define DIOPTRE_TRACE_MATERIALS_FRESNEL_H

#include "trace/math/vec3.h"

/** Half ulps that cos^2 of the refracted angle can be off, where the indices are the same. */
#define REFRACTION_ERROR 32

/** What becomes of LANES rays at an interface. */
typedef struct Refraction {
    Vec3 direction;   /**< Of the refracted rays, one long; any where there is none. */
    real cos_t;       /**< Of the angle between them and the normal. */
    real reflectance; /**< Fresnel's F: the share that is mirrored. */
    mask is_total;    /**< Whether all is: there is no way to refract. */
} Refraction;

/**
 * @return Fresnel's share for light that is not polarised: the mean of the two polarisations.
 * @param cos_i   Cosine of the angle of incidence.
 * @param cos_t  Cosine of the refracted angle.
 * @param eta_i     Index of refraction where the light comes from.
 * @param eta_t       Where it goes to.
 */
INLINE real fresnel_reflectance(real cos_i, real cos_t, real eta_i, real eta_t) {
    real r_perpendicular = (eta_i * cos_i - eta_t * cos_t) / (eta_i * cos_i + eta_t * cos_t);
    real r_parallel = (eta_t * cos_i - eta_i * cos_t) / (eta_t * cos_i + eta_i * cos_t);
    return (r_perpendicular * r_perpendicular + r_parallel * r_parallel) * (scalar)0.5f;
}

/**
 * @return What becomes of rays at an interface. Where the indices are the same, nothing at all
 *         does, to the bit.
 * @param incident  Which way they come, one long.
 * @param n_front  The unit normal on the side that they come from.
 * @param eta_i  Index of refraction on that side.
 * @param relative_error  How much, relatively, the angle of incidence is in doubt besides the
 *         roundings here: total reflection within it is called grazing, which looks the same.
 */
INLINE Refraction refraction_at(Vec3 incident, Vec3 n_front, real eta_i, real eta_t,
                                real relative_error) {
    const real one = real_of(1), zero = real_of(0);
    real cos_i = real_max(real_min(-vec3_dot(incident, n_front), one), zero);
    real eta = eta_i / eta_t, eta_squared = eta * eta;
    // Snell: sin out = ratio sin in. No square is subtracted from 1, which would cancel.
    real cos_squared = 1 - eta_squared * ((1 - cos_i) * (1 + cos_i));
    real slack = eta_squared * (relative_error + REFRACTION_ERROR * ROUNDOFF);
    real cos_t = real_sqrt(real_max(cos_squared, zero));
    Vec3 out = vec3_add(vec3_scale(incident, eta), vec3_scale(n_front, eta * cos_i - cos_t));
    mask is_same = eta_i == eta_t;
    mask is_total = mask_not(is_same) & (cos_squared < -slack);
    real reflectance = real_select(is_total, one, fresnel_reflectance(cos_i, cos_t, eta_i, eta_t));
    return (Refraction){.direction = vec3_select(is_same, incident, vec3_normalize(out)),
                        .cos_t = real_select(is_same, cos_i, cos_t),
                        .reflectance = real_select(is_same, zero, reflectance),
                        .is_total = is_total};
}

#endif
