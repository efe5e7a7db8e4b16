/**
 * @file
 * @brief Surface hits: where the rays of a packet meet surfaces, and what shading needs to know
 *        of those points.
 */
#ifndef DIOPTRE_TRACE_TRACER_SURFACE_HIT_H
#define DIOPTRE_TRACE_TRACER_SURFACE_HIT_H

#include "trace/glass/interior_list.h"
#include "trace/materials/material_ids.h"

/** What happens at transparent surfaces: see trace/glass/dielectric.h. */
typedef struct DielectricHit DielectricHit;

/** The points at which the rays of a packet meet surfaces. */
typedef struct SurfaceHit {
    const Material *materials;       /**< All materials of the scene. */
    const Packet *packet;            /**< The rays; their directions are unit vectors. */
    const Dielectrics *dielectrics;  /**< The scene's transparent shapes. */
    const InteriorList *interior;    /**< The shapes that each ray is inside of; NULL: the scene has
                                          no transparent shape. */
    const DielectricHit *dielectric; /**< What happens at transparent surfaces; NULL: none. */
    Hit hits[PACKET_VECTORS];        /**< The nearest hits. */
    mask is_hit[PACKET_VECTORS];     /**< The rays that meet a shape. */
    mask needs_light[PACKET_VECTORS]; /**< The points that direct light is computed for. */
    mask may_turn[PACKET_VECTORS];    /**< The rays that may be reflected or refracted there. */
    MaterialIds material_ids[PACKET_VECTORS]; /**< The materials at the points. */
    unsigned traits;              /**< What the materials do, all together: see #MATERIAL_SHINES. */
    bool is_uniform;              /**< Whether all points are on one shape. */
    Vec3 n_front[PACKET_VECTORS]; /**< The normals on the side that the rays come from. */
} SurfaceHit;

#endif
