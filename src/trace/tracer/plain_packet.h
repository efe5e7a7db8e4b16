/**
 * @file
 * @brief Plain packets: camera rays that all see the empty sky, or one flat, matt, opaque shape
 * that no other keeps from any lamp.
 *
 * That is most of a room. What makes packets plain is found once for a tile, or else once for a
 * packet; a loop is left in which nothing is searched, selected or recorded. The operations on each
 * ray and their order are those of trace_packet(), and so are the bits. A packet of which any of
 * this cannot be said is not plain.
 */
#ifndef DIOPTRE_TRACE_TRACER_PLAIN_PACKET_H
#define DIOPTRE_TRACE_TRACER_PLAIN_PACKET_H

#include "trace/tracer/tracer.h"

/** What all camera rays of a tile have in common. */
typedef struct PlainTile {
    bool is_possible;           /**< Whether its packets may be plain: the scene has no transparent
                                     shape, texture or visible lamp, and nothing is recorded of the
                                     rays. Else, nothing else is set. */
    BeamCandidates candidates;  /**< The shapes that the rays may meet. */
    const PlaneEquation *plane; /**< The plane of a flat, matt shape that all rays meet first. Each
                                     lamp shines on all of what they meet, or on nothing of it: all
                                     whole packets are plain. NULL: nobody knows of such a plane. */
} PlainTile;

/** Finds what the rays of a tile have in common; not for the reports' methods. @param beam Theirs.
 * @param candidates The shapes that they may meet. */
void plain_tile_find(const Tracer *tracer, const PixelGrid *grid, const Beam *beam,
                     const BeamCandidates *candidates, PlainTile *tile);

/**
 * Finds the colours of a packet of camera rays, if it is plain.
 * @param tile  Where packets may be plain.
 * @param grid  Its pixels.
 * @param index  Index of the packet, below grid_packet_count().
 * @param[out] colors  The radiance that arrives along each ray; undefined if the packet is not
 * plain.
 * @param[in,out] counts  The shadow rays that were spared count as traced.
 * @param[out] only_shape  See #Packet.only_shape.
 * @return Whether it is plain.
 */
bool plain_packet_shade(const Tracer *tracer, const PlainTile *tile, const PixelGrid *grid,
                        PixelJitter jitter, int index, Rgb *colors, RayCounts *counts,
                        const Shape **only_shape);

#endif
