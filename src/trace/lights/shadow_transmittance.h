/**
 * @file
 * @brief Shadow rays through transparent shapes.
 */
#ifndef DIOPTRE_TRACE_LIGHTS_SHADOW_TRANSMITTANCE_H
#define DIOPTRE_TRACE_LIGHTS_SHADOW_TRANSMITTANCE_H

#include "trace/lights/direct_lighting.h"

/**
 * Finds the transmittance of shadow rays: the product of the transparencies of the surfaces that
 * they cross. The rays are not refracted. Surfaces inside a transparent shape that comes later in
 * the scene do not count (see dielectric_hit_find()).
 * @param offset  How rays leave a surface.
 * @param surface  The points that the rays come from.
 * @param shadow  The rays to the light.
 * @param[in,out] occluded  In: the rays that an opaque shape blocks. Out: all rays without light.
 * @param[out] transmittance  Per colour channel, 0 to 1, for each vector of rays.
 */
void shadow_transmittance_find(const ShapeSet *shapes, const RayOffset *offset,
                               const SurfaceHit *surface, const Packet *shadow, mask *occluded,
                               Rgb *transmittance);

#endif
