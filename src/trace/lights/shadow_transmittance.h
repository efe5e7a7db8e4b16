/**
 * @file
 * @brief Filters: what transparent shapes let through of a lamp's light.
 */
#ifndef DIOPTRE_TRACE_LIGHTS_SHADOW_TRANSMITTANCE_H
#define DIOPTRE_TRACE_LIGHTS_SHADOW_TRANSMITTANCE_H

#include "trace/lights/direct_lighting.h"

/**
 * Finds what is left of a lamp's light behind the transparent shapes in its way: the product of the
 * shares that the surfaces let through which it crosses, without being bent. Surfaces that a later
 * transparent shape hides are not there.
 * @param offset  How rays leave a surface.
 * @param surface  The points that the rays come from.
 * @param shadow  The rays to the lamp.
 * @param[in,out] occluded  The rays that an opaque shape is in the way of; then all that get
 *         nothing.
 * @param[out] transmittance  The share that is left, for each vector of rays.
 */
void shadow_transmittance_find(const ShapeSet *shapes, const RayOffset *offset,
                               const SurfaceHit *surface, const Packet *shadow, mask *occluded,
                               Rgb *transmittance);

#endif
