/**
 * @file
 * @brief Ray queries: hits of arbitrary rays, without shading. Benchmarks, tests, the probe and the
 *        laboratory use them.
 */
#ifndef DIOPTRE_TRACE_TRACER_QUERY_H
#define DIOPTRE_TRACE_TRACER_QUERY_H

#include "trace/tracer/tracer.h"

/** Finds the nearest hits of rays. See #Engine.closest_hits. */
void query_closest_hits(const Tracer *tracer, size_t count, const RayQuery *rays, int *shapes,
                        double *distances);

/** Finds which rays hit any shape. See #Engine.occluded. */
void query_occluded(const Tracer *tracer, size_t count, const RayQuery *rays, bool *occluded);

/** Finds all properties of the nearest hits. See #Engine.intersect. */
void query_intersect(const Tracer *tracer, size_t count, const RayQueryQuad *queries,
                     RayResult *results);

#endif
