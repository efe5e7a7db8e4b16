/**
 * @file
 * @brief The camera's rays of a grid of pixels.
 */
#ifndef DIOPTRE_TRACE_GRID_H
#define DIOPTRE_TRACE_GRID_H

#include "trace/sequence.h"
#include "trace/tracer.h"

/** What it takes to trace a grid of pixels. */
typedef struct GridTrace {
    const Tracer *tracer;  /**< The tracer. */
    const PixelGrid *grid; /**< The pixels. */
    SamplePlace place;     /**< Where in their pixels the rays go. */
    double *rgb;           /**< Where their colours go; NULL: they are taken packet by packet. */
    RayCounts *counts;     /**< The rays traced. */
} GridTrace;

/** Follows the camera's rays of a packet of a grid. @param trace The grid. @param column The
 *  packet's first column. @param row Its first row. @param notes What is noted of them;
 *  NULL: nothing. @param[out] colors Their colours. */
void grid_follow(const GridTrace *trace, int column, int row, const Notes *notes, Light3 *colors);

/** Traces a grid of pixels. See #Engine.trace. @param tracer The tracer. @param grid The pixels.
 *  @param[out] rgb Their colours. @param[in,out] counts The rays traced. */
void grid_trace(const Tracer *tracer, const PixelGrid *grid, double *rgb, RayCounts *counts);

/** Finds the nearest hits of a grid of pixels. See #Engine.cast. @param tracer The tracer.
 *  @param grid The pixels. @param[out] shapes What they meet. @param[out] distances How far. */
void grid_cast(const Tracer *tracer, const PixelGrid *grid, int *shapes, double *distances);

#endif
