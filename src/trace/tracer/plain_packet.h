/**
 * @file
 * @brief Plain packets: camera rays that all see the empty sky, or one flat, matt, opaque shape
 * that no other keeps from any lamp.
 *
 * That is most of a room. What makes a packet plain is found once for its beam; a loop is left in
 * which nothing is searched, selected or recorded. The operations on each ray and their order are
 * those of trace_packet(), and so are the bits. A packet of which any of this cannot be said is not
 * plain.
 */
#ifndef DIOPTRE_TRACE_TRACER_PLAIN_PACKET_H
#define DIOPTRE_TRACE_TRACER_PLAIN_PACKET_H

#include "trace/tracer/tracer.h"

/** @return Whether a grid of camera rays may have plain packets: the scene has no transparent
 * shape, texture, visible lamp or report's method, and nothing is recorded of the rays. */
bool plain_packets_are_possible(const Tracer *tracer, const PixelGrid *grid);

/**
 * Finds the colours of a packet of camera rays, if it is plain.
 * @param grid  Its pixels; see plain_packets_are_possible().
 * @param index  Index of the packet, below grid_packet_count().
 * @param[out] colors  The radiance that arrives along each ray; undefined if the packet is not
 * plain.
 * @param[in,out] counts  The shadow rays that were spared count as traced.
 * @return Whether it is plain.
 */
bool plain_packet_shade(const Tracer *tracer, const PixelGrid *grid, PixelJitter jitter, int index,
                        Rgb *colors, RayCounts *counts);

#endif
