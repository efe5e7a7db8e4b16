/**
 * @file
 * @brief Lighting: what the lamps give to the points that a packet of rays has met.
 */
#ifndef DIOPTRE_TRACE_LIGHTING_H
#define DIOPTRE_TRACE_LIGHTING_H

#include "trace/shape_list.h"
#include "trace/surface.h"

/** A light in the engine's number type: see trace/lamp.h. */
typedef struct Lamp Lamp;

/** How rays leave a surface. */
typedef struct Departure {
    OffsetStrategy strategy; /**< Which of the three. */
    scalar epsilon;          /**< For #OFFSET_FIXED: scene units. */
} Departure;

/** The points that a packet of rays has met. */
typedef struct Encounter {
    const Surface *surfaces;             /**< All materials of the scene. */
    const Packet *packet;                /**< The rays, of unit direction. */
    Hit hits[PACKET_VECTORS];            /**< Where. */
    mask met[PACKET_VECTORS];            /**< Which rays met anything. */
    Materials materials[PACKET_VECTORS]; /**< What they met is made of. */
    Vector facing[PACKET_VECTORS];       /**< The normals, turned to where the rays come from. */
} Encounter;

/** What the lamps give, before the surfaces weigh it. */
typedef struct Lighting {
    Light3 matt[PACKET_VECTORS];      /**< Sum of V L f max(0, n . l). */
    Light3 highlight[PACKET_VECTORS]; /**< Sum of V L f max(0, r . v)^shininess. */
} Lighting;

/**
 * @return Where rays that leave a surface start: moved along the normal, to the side that they
 *         travel to, by nothing, a fixed length or the hit's own error bound (doc/tour.md, "Leaving
 *         a surface").
 * @param departure  How far.
 * @param hit        The surface.
 * @param direction  Which way they leave.
 */
INLINE Vector departure_origin(const Departure *departure, const Hit *hit, Vector direction) {
    if (departure->strategy == OFFSET_NONE) {
        return hit->point;
    }
    real far = departure->strategy == OFFSET_FIXED ? real_of(departure->epsilon) : hit->error;
    mask is_outwards = vector_dot(direction, hit->normal) >= 0;
    return vector_add(hit->point, vector_scale(hit->normal, real_select(is_outwards, far, -far)));
}

/**
 * Adds up the light of all lamps (rows A3 to A6, C4).
 * @param list        The shapes, which may stand in the way.
 * @param lamps       The lamps.
 * @param lamp_count  How many.
 * @param departure   Where shadow rays start.
 * @param shines      Whether any surface has highlights; otherwise they are not computed.
 * @param met         The points.
 * @param[out] lighting  What they get.
 * @return How many shadow rays were traced.
 */
uint64_t lighting_gather(const ShapeList *list, const Lamp *lamps, size_t lamp_count,
                         const Departure *departure, bool shines, const Encounter *met,
                         Lighting *lighting);

#endif
