/**
 * @file
 * @brief Questions from outside: what do these rays meet?
 *
 * They are rays of a bench, of a test, of a laboratory: of no picture, so nothing is shaded, and no
 * other ray follows.
 */
#ifndef DIOPTRE_TRACE_ASK_H
#define DIOPTRE_TRACE_ASK_H

#include "trace/tracer.h"

/** Finds the nearest hits of any rays. See #Engine.nearest. @param tracer The tracer.
 *  @param count How many. @param rays The rays. @param[out] shapes What they meet.
 *  @param[out] distances How far. */
void ask_nearest(const Tracer *tracer, size_t count, const PlainRay *rays, int *shapes,
                 double *distances);

/** Finds which of any rays meet anything. See #Engine.shadowed. @param tracer The tracer.
 *  @param count How many. @param rays The rays. @param[out] shadowed Whether each does. */
void ask_shadowed(const Tracer *tracer, size_t count, const PlainRay *rays, bool *shadowed);

/** Answers any rays in full. See #Engine.intersect. @param tracer The tracer. @param count How
 *  many. @param queries The rays. @param[out] answers The answers. */
void ask_intersect(const Tracer *tracer, size_t count, const RayQuery *queries, RayAnswer *answers);

#endif
