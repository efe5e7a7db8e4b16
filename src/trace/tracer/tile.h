/**
 * @file
 * @brief Tiles: grids of pixels, traced packet by packet.
 */
#ifndef DIOPTRE_TRACE_TRACER_TILE_H
#define DIOPTRE_TRACE_TRACER_TILE_H

#include "trace/tracer/tracer.h"

/** The camera rays of a packet, and the memory that their state points to. */
typedef struct CameraRays {
    RayState state;                        /**< The rays. */
    InteriorList interior[PACKET_VECTORS]; /**< The shapes that the camera is inside of. */
    uint32_t pixel_ids[PACKET_RAYS];       /**< See #SampleContext. */
} CameraRays;

/**
 * Generates the camera rays of a packet of a grid.
 * @param jitter  Where in its pixel each ray goes.
 * @param index  Index of the packet, below grid_packet_count().
 * @param[in,out] run  See camera_generate_rays().
 * @param recorders  What is recorded of the rays; NULL: nothing.
 * @param[out] rays  The rays; it contains pointers into itself.
 */
void camera_rays_init(const Tracer *tracer, const PixelGrid *grid, PixelJitter jitter, int index,
                      CameraRun *run, const Recorders *recorders, CameraRays *rays);

/** The elements of an output array that the lanes of a vector are written to, one by one. */
typedef struct OutputRange {
    size_t first; /**< Index of the first element. */
    int count;    /**< Lanes that are written, from the first on: 0 to LANES. */
} OutputRange;

/** @return The elements of a vector: an array has one per pixel of the grid, or per selected pixel.
 *  @param index Index of the packet. */
static inline OutputRange output_range(const PixelGrid *grid, int index, int v) {
    size_t first, left;
    if (grid->selected) {
        first = (size_t)index * PACKET_RAYS + (size_t)v * LANES;
        left = first < grid->selected_count ? grid->selected_count - first : 0;
    } else {
        GridPosition position = grid_vector_position(grid_packet_position(grid, index), v);
        first = (size_t)position.row * (size_t)grid->columns + (size_t)position.column;
        left = position.row < grid->rows && position.column < grid->columns
                   ? (size_t)(grid->columns - position.column)
                   : 0;
    }
    return (OutputRange){first, left < LANES ? (int)left : LANES};
}

/** Traces a grid of pixels. See #Engine.trace. */
void trace_tile(const Tracer *tracer, const PixelGrid *grid, double *rgb, RayCounts *counts);

/** Finds the nearest hits of a grid of pixels. See #Engine.trace_primary. */
void trace_tile_primary(const Tracer *tracer, const PixelGrid *grid, int *shapes,
                        double *distances);

#endif
