/**
 * @file
 * @brief Questions from outside: what do these rays meet?
 *
 * They are rays of a bench, of a test, of a laboratory: of no picture, so nothing is shaded, and no
 * other ray follows.
 */
#ifndef DIOPTRE_TRACE_TRACER_QUERY_H
#define DIOPTRE_TRACE_TRACER_QUERY_H

#include "trace/tracer/tracer.h"

/** Finds the nearest hits of any rays. See #Engine.closest_hits. */
void query_closest_hits(const Tracer *tracer, size_t count, const RayQuery *rays, int *shapes,
                        double *distances);

/** Finds which of any rays meet anything. See #Engine.occluded. */
void query_occluded(const Tracer *tracer, size_t count, const RayQuery *rays, bool *occluded);

/** Answers any rays in full. See #Engine.intersect. */
void query_intersect(const Tracer *tracer, size_t count, const RayQueryQuad *queries,
                     RayResult *results);

#endif
