/**
 * @file
 * @brief Lighting: what the lamps give to the points that a packet of rays has met.
 */
#ifndef DIOPTRE_TRACE_LIGHTING_H
#define DIOPTRE_TRACE_LIGHTING_H

#include "trace/departure.h"
#include "trace/materials.h"
#include "trace/media.h"

/** A light in the engine's number type: see trace/lamp.h. */
typedef struct Lamp Lamp;

/** The points that a packet of rays has met. */
typedef struct Encounter {
    const Surface *surfaces;             /**< All materials of the scene. */
    const Packet *packet;                /**< The rays, of unit direction. */
    const Glass *glass;                  /**< What the scene has of glass. */
    const Media *media;                  /**< What the rays are in; NULL: there is no glass. */
    Hit hits[PACKET_VECTORS];            /**< Where. */
    mask met[PACKET_VECTORS];            /**< Which rays met anything. */
    mask lit[PACKET_VECTORS];            /**< Which of the points ask for light. */
    Materials materials[PACKET_VECTORS]; /**< What they met is made of. */
    Vector facing[PACKET_VECTORS];       /**< The normals, turned to where the rays come from. */
} Encounter;

/** What the lamps give, before the surfaces weigh it. */
typedef struct Lighting {
    Light3 matt[PACKET_VECTORS];      /**< Sum of V L f max(0, n . l). */
    Light3 highlight[PACKET_VECTORS]; /**< Sum of V L f max(0, r . v)^shininess. */
} Lighting;

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
