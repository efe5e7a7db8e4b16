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

/** Finds the nearest hits of any rays. See #Engine.closest_hits. @param tracer The tracer.
 *  @param count How many. @param rays The rays. @param[out] shapes What they meet.
 *  @param[out] distances How far. */
void query_closest_hits(const Tracer *tracer, size_t count, const RayQuery *rays, int *shapes,
                        double *distances);

/** Finds which of any rays meet anything. See #Engine.occluded. @param tracer The tracer.
 *  @param count How many. @param rays The rays. @param[out] occluded Whether each does. */
void query_occluded(const Tracer *tracer, size_t count, const RayQuery *rays, bool *occluded);

/** Answers any rays in full. See #Engine.intersect. @param tracer The tracer. @param count How
 *  many. @param queries The rays. @param[out] results The answers. */
void query_intersect(const Tracer *tracer, size_t count, const RayQueryQuad *queries,
                     RayResult *results);

#endif
