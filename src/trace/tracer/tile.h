/**
 * @file
 * @brief The camera's rays of a grid of pixels.
 */
#ifndef DIOPTRE_TRACE_TRACER_TILE_H
#define DIOPTRE_TRACE_TRACER_TILE_H

#include "trace/math/sobol.h"
#include "trace/tracer/tracer.h"

/** What it takes to trace a grid of pixels. */
typedef struct TileTrace {
    const Tracer *tracer;  /**< The tracer. */
    const PixelGrid *grid; /**< The pixels. */
    PixelJitter jitter;    /**< Where in their pixels the rays go. */
    double *rgb;           /**< Where their colours go; NULL: they are taken packet by packet. */
    RayCounts *counts;     /**< The rays traced. */
} TileTrace;

/** Follows the camera's rays of a packet of a grid. @param recorders What is noted of them; NULL:
 *  nothing. */
void trace_tile_packet_colors(const TileTrace *tile, int column, int row,
                              const Recorders *recorders, Rgb *colors);

/** Traces a grid of pixels. See #Engine.trace. */
void trace_tile(const Tracer *tracer, const PixelGrid *grid, double *rgb, RayCounts *counts);

/** Finds the nearest hits of a grid of pixels. See #Engine.trace_primary. */
void trace_tile_primary(const Tracer *tracer, const PixelGrid *grid, int *shapes,
                        double *distances);

#endif
