/**
 * @file
 * @brief Refraction at the interface of two media: Snell's law for the direction, and Fresnel's
 *        equations for the reflectance (*Mémoire sur la loi des modifications que la réflexion
 *        imprime à la lumière polarisée*, 1823). See doc/tour.md, "Glass".
 */
#ifndef DIOPTRE_TRACE_MATERIALS_FRESNEL_H
#define DIOPTRE_TRACE_MATERIALS_FRESNEL_H

#include "trace/math/vec3.h"

/** Error bound of cos^2 of the refraction angle, in half ulps, for equal indices. */
#define REFRACTION_ERROR 32

/** LANES rays at an interface. */
typedef struct Refraction {
    Vec3 direction;   /**< Unit direction of the refracted rays; undefined where #is_total. */
    real cos_t;       /**< Cosine of the refraction angle. */
    real reflectance; /**< Fresnel reflectance F, 0 to 1. */
    mask is_total;    /**< Total internal reflection: no refracted ray exists. */
} Refraction;

/**
 * @return The Fresnel reflectance of unpolarized light: the mean of both polarizations.
 * @param cos_i  Cosine of the angle of incidence.
 * @param cos_t  Cosine of the refraction angle.
 * @param eta_i  Index of refraction on the incident side.
 * @param eta_t  Index of refraction on the other side.
 */
INLINE real fresnel_reflectance(real cos_i, real cos_t, real eta_i, real eta_t) {
    real r_perpendicular = (eta_i * cos_i - eta_t * cos_t) / (eta_i * cos_i + eta_t * cos_t);
    real r_parallel = (eta_t * cos_i - eta_i * cos_t) / (eta_t * cos_i + eta_i * cos_t);
    real mean = (r_perpendicular * r_perpendicular + r_parallel * r_parallel) * (scalar)0.5f;
    // Along the surface on both sides these are 0 / 0; all is reflected in the limit.
    return real_select(cos_t > 0, mean, real_of(1));
}

/**
 * @return Refraction and reflectance of rays. Between equal indices the direction does not change
 * by one bit.
 * @param incident  Unit directions of the rays.
 * @param n_front  The unit normal on the incident side.
 * @param eta_i  Index of refraction on that side.
 * @param relative_error  Relative error of the angle of incidence, besides the roundings here.
 * Total reflection within this error is treated as refraction at a grazing angle: it looks the
 *         same.
 */
INLINE Refraction refraction_at(Vec3 incident, Vec3 n_front, real eta_i, real eta_t,
                                real relative_error) {
    const real one = real_of(1), zero = real_of(0);
    real cos_i = real_max(real_min(-vec3_dot(incident, n_front), one), zero);
    real eta = eta_i / eta_t, eta_squared = eta * eta;
    // Snell: sin_t = eta sin_i; sin_i^2 = (1 - cos_i)(1 + cos_i), since 1 - cos_i^2 would cancel.
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
