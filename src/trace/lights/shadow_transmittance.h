/**
 * @file
 * @brief Shadow rays through transparent shapes.
 */
#ifndef DIOPTRE_TRACE_LIGHTS_SHADOW_TRANSMITTANCE_H
#define DIOPTRE_TRACE_LIGHTS_SHADOW_TRANSMITTANCE_H

#include "trace/lights/direct_lighting.h"

/** @return The transparent shapes that can take light from shadow rays. @param offset How rays
 * leave a surface. */
const ShapeSet *shadow_transmittance_shapes(const Dielectrics *dielectrics,
                                            const RayOffset *offset);

/**
 * Finds the transmittance of shadow rays: the product of the transparencies of the surfaces that
 * they cross. The rays are not refracted. Surfaces inside a transparent shape that comes later in
 * the scene do not count (see dielectric_hit_find()).
 * @param glass  By shadow_transmittance_shapes().
 * @param offset  How rays leave a surface.
 * @param surface  The points that the rays come from.
 * @param shadow  The rays to the light.
 * @param[in,out] occluded  In: the rays that an opaque shape blocks. Out: all rays without light.
 * @param[in,out] transmittance  Per colour channel, 0 to 1, for each vector of rays; in: 1.
 */
void shadow_transmittance_find(const ShapeSet *shapes, const ShapeSet *glass,
                               const RayOffset *offset, const SurfaceHit *surface,
                               const Packet *shadow, mask *occluded, Rgb *transmittance);

#endif
