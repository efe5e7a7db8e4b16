/**
 * @file
 * @brief The camera's rays of a grid of pixels.
 */
#ifndef DIOPTRE_TRACE_GRID_H
#define DIOPTRE_TRACE_GRID_H

#include "trace/tracer.h"

/** Traces a grid of pixels. See #Engine.trace. @param tracer The tracer. @param grid The pixels.
 *  @param[out] rgb Their colours. @param[in,out] counts The rays traced. */
void grid_trace(const Tracer *tracer, const PixelGrid *grid, double *rgb, RayCounts *counts);

/** Finds the nearest hits of a grid of pixels. See #Engine.cast. @param tracer The tracer.
 *  @param grid The pixels. @param[out] shapes What they meet. @param[out] distances How far. */
void grid_cast(const Tracer *tracer, const PixelGrid *grid, int *shapes, double *distances);

#endif
