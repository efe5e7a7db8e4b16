/**
 * @file
 * @brief Crossings: what becomes of a packet of rays at the transparent surfaces that it has met.
 */
#ifndef DIOPTRE_TRACE_GLASS_DIELECTRIC_H
#define DIOPTRE_TRACE_GLASS_DIELECTRIC_H

#include "trace/tracer/surface_hit.h"

/** What becomes of rays at transparent surfaces. */
typedef struct DielectricHit {
    mask is_transmitted[PACKET_VECTORS]; /**< The rays that go on behind the surface. */
    mask is_overridden[PACKET_VECTORS];  /**< Those whose surface is not there: a later shape is. */
    real reflectance[PACKET_VECTORS];    /**< Fresnel's share of what is not the body's; else 0. */
    Vec3 origin[PACKET_VECTORS];         /**< Where the rays behind the surface start. */
    Vec3 direction[PACKET_VECTORS];      /**< Which way they go, one long. */
    InteriorList interior[PACKET_VECTORS]; /**< What they are inside of. */
} DielectricHit;

/**
 * Finds what becomes of rays at transparent surfaces.
 * @param dielectrics  What the scene has of glass.
 * @param offset  How rays leave a surface.
 * @param[in,out] surface  What the rays met; points that ask for no light are taken out of `lit`.
 * @return How many are reflected totally.
 */
unsigned dielectric_hit_find(const Dielectrics *dielectrics, const RayOffset *offset,
                             SurfaceHit *surface, DielectricHit *dielectric);

/**
 * @return The share of what rays bring back that is mirrored: R + T F; nothing where the surface is
 *         not there.
 * @param dielectric  What becomes of the rays; NULL: there is no glass.
 * @param v  Which vector of them.
 */
INLINE Rgb dielectric_hit_reflectance(const DielectricHit *dielectric, int v,
                                      const MaterialPack *material) {
    if (!dielectric) {
        return material->reflectance;
    }
    Rgb fresnel = rgb_scale(material->transmittance, dielectric->reflectance[v]);
    Rgb black = {real_of(0), real_of(0), real_of(0)};
    return rgb_select(dielectric->is_overridden[v], black, rgb_add(material->reflectance, fresnel));
}

/**
 * @return The share that comes from behind the surface: T (1 - F); all where the surface is not
 *         there.
 * @param dielectric  What becomes of the rays.
 * @param v  Which vector of them.
 */
INLINE Rgb dielectric_hit_transmittance(const DielectricHit *dielectric, int v,
                                        const MaterialPack *material) {
    Rgb one = {real_of(1), real_of(1), real_of(1)};
    Rgb weight = rgb_scale(material->transmittance, 1 - dielectric->reflectance[v]);
    return rgb_select(dielectric->is_overridden[v], one, weight);
}

#endif
