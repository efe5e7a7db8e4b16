/**
 * @file
 * @brief Contact of opaque surfaces with glass: a glass that stands on a table.
 */
#ifndef DIOPTRE_TRACE_GLASS_CONTACT_H
#define DIOPTRE_TRACE_GLASS_CONTACT_H

#include "trace/tracer/surface_hit.h"

/**
 * Replaces hits of glass by those of opaque surfaces at the same place. Roundings decide which of
 * two such walls is met first. Behind the glass wall, a refracted ray would start beyond the opaque
 * surface: it would miss it, or be totally reflected at air that is not there.
 *
 * Rays that leave an opaque surface that may touch glass start #TOUCHING_OFFSET_SCALE bounds away,
 * on the other side of a glass wall at the same place.
 * @param offset  How far from a surface rays start.
 * @param[in,out] surface  The hits.
 */
void contacts_resolve(const RayOffset *offset, SurfaceHit *surface);

#endif
