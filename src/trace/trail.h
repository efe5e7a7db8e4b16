/**
 * @file
 * @brief Trails: a number for each ray of the camera that says which way its light took.
 *
 * Two pictures may differ in a pixel because numbers were rounded, or because a ray passed an edge
 * on its other side: then it has met something else. The trails tell which. Nobody else asks for
 * them, and where nobody does, a packet costs one look at a pointer.
 */
#ifndef DIOPTRE_TRACE_TRAIL_H
#define DIOPTRE_TRACE_TRAIL_H

#include "trace/lighting.h"

/**
 * Notes what rays have met: which shape, and on which side of its edges, as their normals differ.
 * @param met  The surfaces; its packet has trails.
 */
void trail_surfaces(const Encounter *met);

/**
 * Notes which points a lamp does not reach.
 * @param met      The points; their packet has trails.
 * @param shadow   The rays to the lamp.
 * @param blocked  Those with something in their way.
 * @param visible  The share that glass leaves; NULL: there is no glass.
 */
void trail_shadows(const Encounter *met, const Packet *shadow, const mask *blocked,
                   const Light3 *visible);

#endif
