/**
 * @file
 * @brief Rays at transparent surfaces: Fresnel reflectance and refracted rays of a packet.
 */
#ifndef DIOPTRE_TRACE_GLASS_DIELECTRIC_H
#define DIOPTRE_TRACE_GLASS_DIELECTRIC_H

#include "trace/tracer/surface_hit.h"

/** What happens to rays at transparent surfaces. A surface is overridden where a later shape of the
 *  scene is on both of its sides: light passes as if it did not exist. */
struct DielectricHit {
    mask is_transmitted[PACKET_VECTORS]; /**< The rays that continue behind a surface. */
    mask is_overridden[PACKET_VECTORS];  /**< The rays at overridden surfaces. */
    real reflectance[PACKET_VECTORS]; /**< Fresnel reflectance F, 0 to 1; 0 at opaque surfaces. */
    Vec3 origin[PACKET_VECTORS];      /**< Origins of the refracted rays. */
    Vec3 direction[PACKET_VECTORS];   /**< Unit directions of the refracted rays. */
    InteriorList *interior_behind;    /**< The shapes that those are inside of, per vector. */
};

/**
 * Finds what happens to rays at transparent surfaces.
 * @param offset  How far behind a surface refracted rays start.
 * @param[in,out] surface  The hits. Points without diffuse and specular reflection are removed from
 *         #SurfaceHit.needs_light; #SurfaceHit.dielectric is set.
 * @param[out] interior_behind  Memory for #DielectricHit.interior_behind: PACKET_VECTORS lists.
 * @return The number of rays that are totally reflected.
 */
unsigned dielectric_hit_find(const RayOffset *offset, SurfaceHit *surface,
                             InteriorList *interior_behind, DielectricHit *dielectric);

/** @return R + T F, the weight of reflected rays; 0 at overridden surfaces. */
INLINE Rgb surface_reflectance(const SurfaceHit *surface, int v, const MaterialPack *material) {
    const DielectricHit *dielectric = surface->dielectric;
    if (!dielectric) {
        return material->reflectance;
    }
    Rgb fresnel = rgb_scale(material->transmittance, dielectric->reflectance[v]);
    Rgb black = {real_of(0), real_of(0), real_of(0)};
    return rgb_select(dielectric->is_overridden[v], black, rgb_add(material->reflectance, fresnel));
}

/** @return T (1 - F), the weight of refracted rays; 1 at overridden surfaces. */
INLINE Rgb surface_transmittance(const SurfaceHit *surface, int v, const MaterialPack *material) {
    const DielectricHit *dielectric = surface->dielectric;
    Rgb one = {real_of(1), real_of(1), real_of(1)};
    Rgb weight = rgb_scale(material->transmittance, 1 - dielectric->reflectance[v]);
    return rgb_select(dielectric->is_overridden[v], one, weight);
}

/** @return The origins of reflected rays: on their line where a surface reflects by Fresnel's
 *  formulas. @param direction Their unit directions. */
INLINE Vec3 surface_reflection_origin(const RayOffset *offset, const SurfaceHit *surface, int v,
                                      Vec3 direction) {
    const Hit *hit = &surface->hits[v];
    Vec3 origin = ray_offset_origin(offset, hit, direction);
    if (!surface->dielectric) {
        return origin;
    }
    Vec3 on_line = ray_offset_reflected_origin(offset, hit, surface->n_front[v], direction);
    return vec3_select(surface->dielectric->reflectance[v] > 0, on_line, origin);
}

#endif
