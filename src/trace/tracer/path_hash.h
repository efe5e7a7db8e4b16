/**
 * @file
 * @brief Path hashes: a number per camera ray that identifies the path that its light took.
 *
 * Two images may differ at a pixel because of rounding, or because a ray passed an edge on the
 * other side and hit something else. The path hashes tell these cases apart. Without a recorder, a
 * packet costs one test of a pointer.
 */
#ifndef DIOPTRE_TRACE_TRACER_PATH_HASH_H
#define DIOPTRE_TRACE_TRACER_PATH_HASH_H

#include "trace/tracer/surface_hit.h"

/** Adds the hits of a packet with #Recorders.path_hashes: the shapes, and their coarsely quantized
 *  normals, which tell the faces of a shape apart. */
void path_hash_add_surfaces(const SurfaceHit *surface);

/**
 * Adds the shadow rays to one light of a packet with #Recorders.path_hashes.
 * @param surface  The points that they start from.
 * @param shadow  The shadow rays.
 * @param occluded  The rays that do not reach the light.
 * @param transmittance  The transmittance of the transparent shapes on them; NULL: there are none.
 */
void path_hash_add_shadows(const SurfaceHit *surface, const Packet *shadow, const mask *occluded,
                           const Rgb *transmittance);

#endif
