/**
 * @file
 * @brief Shafts: planes through one point between which all rays of a packet run.
 *
 * A shape beyond one of the planes is missed by all rays. How far a shape reaches along the normal
 * of a plane is its support function (#ShapeClass.support), which is short for each convex shape:
 * the planes of a shaft are in the lanes of a vector, so one call asks for all (Haines, Wallace,
 * *Shaft Culling for Efficient Ray-Cast Radiosity*, 1991).
 */
#ifndef DIOPTRE_TRACE_TRACER_SHAFT_H
#define DIOPTRE_TRACE_TRACER_SHAFT_H

#include "trace/tracer/packet.h"

/** Most planes of a shaft: two per pair of axes. */
enum { SHAFT_PLANES = 6 };
/** Vectors with a plane in each lane. */
enum { SHAFT_VECTORS = (SHAFT_PLANES + LANES - 1) / LANES };

/** A shaft: all points p of the rays have inward . (p - apex) >= -slack for each plane. */
typedef struct Shaft {
    Vec3s apex;                 /**< The point. */
    int vector_count;           /**< Number of vectors with planes; 0: nothing is missed. */
    Vec3 inward[SHAFT_VECTORS]; /**< Normals of the planes, of any length; 0: no plane. */
    real slack[SHAFT_VECTORS];  /**< See above; 0 or more. */
} Shaft;

/** Finds the shaft of a beam: its sides, a little farther apart, so that rays and roundings are
 *  within. A beam that is not narrow, or a single ray, has no planes. */
void beam_shaft(const Beam *beam, Shaft *shaft);

/** Finds the shaft of rays that end at a point: planes along one axis each, which touch the box
 * of the origins. @param intervals Those of the rays; they have a #PacketIntervals.region. */
void intervals_shaft(const PacketIntervals *intervals, Shaft *shaft);

/** @return Whether all rays in a shaft surely miss a shape, which has a #ShapeClass.support. */
bool shaft_misses(const Shaft *shaft, const Shape *shape);

#endif
