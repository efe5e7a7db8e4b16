/**
 * @file
 * @brief Trails: a number for each ray of the camera that says which way its light took.
 *
 * Two pictures may differ in a pixel because numbers were rounded, or because a ray passed an edge
 * on its other side: then it has met something else. The trails tell which. Nobody else asks for
 * them, and where nobody does, a packet costs one look at a pointer.
 */
#ifndef DIOPTRE_TRACE_TRACER_PATH_HASH_H
#define DIOPTRE_TRACE_TRACER_PATH_HASH_H

#include "trace/tracer/surface_hit.h"

/**
 * Notes what rays have met: which shape, and on which side of its edges, as their normals differ.
 * @param surface  The surfaces; its packet has trails.
 */
void path_hash_add_surfaces(const SurfaceHit *surface);

/**
 * Notes which points a lamp does not reach.
 * @param surface      The points; their packet has trails.
 * @param shadow   The rays to the lamp.
 * @param occluded  Those with something in their way.
 * @param transmittance  The share that glass leaves; NULL: there is no glass.
 */
void path_hash_add_shadows(const SurfaceHit *surface, const Packet *shadow, const mask *occluded,
                           const Rgb *transmittance);

#endif
