/**
 * @file
 * @brief Direct lighting: what the lights give to the points that a packet of rays has met.
 */
#ifndef DIOPTRE_TRACE_LIGHTS_DIRECT_LIGHTING_H
#define DIOPTRE_TRACE_LIGHTS_DIRECT_LIGHTING_H

#include "trace/tracer/surface_hit.h"

/** A light in the engine's number type: see trace/lights/light.h. */
typedef struct Light Light;

/** What the lights give, before the materials weigh it. */
typedef struct DirectLighting {
    Rgb diffuse[PACKET_VECTORS];  /**< Sum of V L f max(0, n . l). */
    Rgb specular[PACKET_VECTORS]; /**< Sum of V L f max(0, r . v)^shininess; set only where any
                                       surface has highlights. */
} DirectLighting;

/**
 * Adds up the light of all lights: one shadow ray per light and point.
 * @param shapes  The shapes that may be in the way.
 * @param offset  Where shadow rays start.
 * @param has_specular  Whether any surface has highlights; else they are not computed.
 * @return How many shadow rays were traced.
 */
uint64_t shade_direct(const ShapeSet *shapes, const Light *lights, size_t light_count,
                      const RayOffset *offset, bool has_specular, const SurfaceHit *surface,
                      DirectLighting *lighting);

#endif
